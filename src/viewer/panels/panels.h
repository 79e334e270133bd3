#pragma once

#include "widgets.h"

#include <viewer/state/viewer_model.h>

namespace cdr::viewer {

// What stands in the column beside the picture, one function per group. Each shows a part of the model and
// changes what a person changes; nothing else follows from it.

void drawScenePanel(const Widgets& widgets, ViewerModel& model);
void drawTechniquePanel(const Widgets& widgets, ViewerModel& model);
void drawViewPanel(const Widgets& widgets, ViewerModel& model);
/// How the frame is made. New renderer switches belong here.
void drawRenderingPanel(const Widgets& widgets, ViewerModel& model);
void drawFinishPanel(const Widgets& widgets, ViewerModel& model);
void drawCameraPanel(const Widgets& widgets, ViewerModel& model);
void drawFrameGraph(const Widgets& widgets, const ViewerModel& model);
void drawTimeline(const Widgets& widgets, const ViewerModel& model);
void drawCascadesPanel(const Widgets& widgets, const ViewerModel& model);
void drawMemoryPanel(const Widgets& widgets, const ViewerModel& model);
/// Only where a file has animations.
void drawAnimationPanel(const Widgets& widgets, ViewerModel& model);
void drawMeasuringPanel(const Widgets& widgets, ViewerModel& model);

/// All of it in a column of that width at the window's right edge, in tabs.
void drawSidebar(const Widgets& widgets, ItemPlaces& places, float width, ViewerModel& model);
/// Keys and what they do, over everything.
void drawHelp(ViewerModel& model);

} // namespace cdr::viewer
