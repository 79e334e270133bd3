#pragma once

#include "widgets.h"

#include <viewer/state/model/viewer_model.h>

namespace cdr::viewer {

// What stands in the column beside the picture, one function per group. Each shows a part of the model and
// changes what a person changes; nothing else follows from it. The result is what is shown, null while nothing is.

void drawScenePanel(const Widgets& widgets, const RenderResult* result, ViewSettings& settings);
void drawTechniquePanel(const Widgets& widgets, ViewSettings& settings);
void drawViewPanel(const Widgets& widgets, ViewSettings& settings);
/// How the frame is made. New renderer switches belong here.
void drawRenderingPanel(const Widgets& widgets, ViewSettings& settings);
void drawFinishPanel(const Widgets& widgets, ViewSettings& settings);
/// One eye or two.
void drawEyesPanel(const Widgets& widgets, ViewerModel& model);
void drawCameraPanel(const Widgets& widgets, ViewerModel& model);
void drawFrameGraph(const Widgets& widgets, const PerformanceModel& performance);
void drawTimeline(const Widgets& widgets, const RenderResult* result);
void drawCascadesPanel(const Widgets& widgets, const RenderResult* result, base::LengthUnit unit);
void drawMemoryPanel(const Widgets& widgets, const RenderResult* result, const PerformanceModel& performance);
/// Only where a file has animations.
void drawAnimationPanel(const Widgets& widgets, const RenderResult* result, ViewSettings& settings,
                        Playback& playback);
void drawMeasuringPanel(const Widgets& widgets, ViewerModel& model);
/// The layers of what was picked last.
void drawLayersPanel(const Widgets& widgets, const PictureModel& picture, ViewSettings& settings);

/// All of it in a column of that width at the window's right edge, in tabs.
void drawSidebar(const Widgets& widgets, ItemPlaces& places, float width, ViewerModel& model);
/// Keys and what they do, over everything.
void drawHelp(InterfaceModel& interface);

} // namespace cdr::viewer
