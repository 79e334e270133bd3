#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

namespace cdr::measure {

/// The picture a renderer without depth errors shows: the true surface of every pixel, lit in float64 as the
/// shading pass lights it. 8-bit sRGB, within a step or two of a rendered picture wherever that shows the
/// same object. It shares no code with the renderer. It is neither exposed nor tone mapped, so under a sky or in air it is like a
/// picture that is told not to be (render::ToneMap::none) alone.
///
/// For scenes of boxes with one instance per object, such as the 2AFC scenes. A truth pixel holds no normal, and
/// a box's normal follows from the position. base::InputError for other scenes.
/// @param truth cast from the same scene and camera.
image::ImageRgba8 shadeTruth(const scene::Scene& scene, const scene::Camera& camera, const TruthImage& truth,
                             platform::WorkerPool& workers);

/// The truth-ordered render: `picture` where it shows the true object, the true surface's colour elsewhere.
/// The two differ only by what depth got wrong, not by rounding. base::InputError when the sizes differ.
image::ImageRgba8 orderByTruth(const image::ImageRgba8& picture, const image::ImageU32& ids,
                               const TruthImage& truth, const image::ImageRgba8& shaded);

} // namespace cdr::measure
