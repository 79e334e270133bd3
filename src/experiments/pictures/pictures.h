#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/scene_setup.h>
#include <experiments/progress.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Figures 6.1 to 6.3: one picture per technique, what is wrong in it beside it.
struct PicturesOptions {
    render::RenderOptions drawing{}; ///< but for the technique
    std::uint32_t frames = 3;        ///< spread evenly over each scene's camera path; a still scene has one
    std::uint64_t seed = 2013;       ///< of the scenes
    std::vector<depth::NamedTechnique> techniques{depth::presets().begin(), depth::presets().end()};
};

/// One technique over one scene.
struct PictureResult {
    std::string scene;
    std::string technique;
    double fovYDegrees = 0.0;
    std::uint32_t frames = 0;
    measure::WrongPixels wrong; ///< summed over the frames
    std::uint64_t flips = 0;    ///< measure::countFlips, summed over neighbouring frames
    image::ImageRgba8 picture;  ///< of the first frame
    image::ImageRgba8 heatMap;  ///< of the first frame
};

std::vector<PictureResult> runPictures(const gpu::Device& device, std::vector<scene::SceneSetup> scenes,
                                       const PicturesOptions& options, const NamedProgress& progress);

/// All pictures over their heat maps with captions, one column per technique, two rows per scene.
image::ImageRgba8 makeContactSheet(const std::vector<PictureResult>& results, const std::string& title);

} // namespace cdr::experiments
