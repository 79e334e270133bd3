#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>

#include <ranks/ranks.h>
#include <rivals/rival.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// The 2AFC experiment (thesis section 6.1) without people: the same frames, measured against the truth.
struct FlickerOptions {
    render::RenderOptions drawing{}; ///< but for the technique; rivals are not snapped
    std::uint32_t frames = 360; ///< spread evenly over the camera's turn of 360, beyond which cameras repeat
    std::uint64_t seed = 2013;
    std::vector<depth::NamedTechnique> techniques{depth::presets().begin(), depth::presets().end()};
    std::vector<rivals::NamedRival> rivalsBeside{}; ///< measured as the techniques are, behind them
    /// Puts a tiny object beside the camera (scene afc-near), so that fitting near and far does not help.
    bool nearObject = false;
    std::uint32_t flipEvery = 1; ///< FLIP is taken of every so-many-th frame; at least 1
};

/// One technique or rival over all frames.
struct FlickerResult {
    std::string scene;
    std::string technique;
    std::optional<depth::DepthFormat> format; ///< none for a rival, which has keys of 64 bits
    std::uint32_t frames = 0;
    measure::WrongPixels wrong;   ///< summed over the frames
    measure::FlipCount flips;     ///< summed over neighbouring frames
    double flipSum = 0.0;         ///< of the mean FLIP of each frame it was taken of
    std::uint32_t flipFrames = 0; ///< frames FLIP was taken of; 0 for a rival, which shades nothing
    double duplicationSum = 0.0;  ///< of each frame's draws per visible instance
    std::size_t cascades = 0;     ///< the most of any frame

    bool isRival() const { return !format; }
    /// Mean FLIP against the truth-ordered render (measure::orderByTruth), over all pixels.
    double meanFlip() const { return flipFrames ? flipSum / flipFrames : 0.0; }
    double duplication() const { return frames ? duplicationSum / frames : 1.0; }
};

/// Takes a frame's pictures, in the techniques' order.
using FlickerPictures =
    std::function<void(std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures)>;

/// One result per technique, then per rival, in their order. base::InputError for unusable options, and a rival that the
/// device cannot draw.
/// @param ranks that share the frames. The first one has results.
std::vector<FlickerResult> runFlicker(const gpu::Device& device, const FlickerOptions& options,
                                      const NamedProgress& progress, ranks::Ranks& ranks);

/// Draws the frames that runFlicker() measures, by the techniques that are named. Rivals have no pictures.
/// @param take of the first rank, which gets the frames in order.
void showFlicker(const gpu::Device& device, const FlickerOptions& options, const NamedProgress& progress,
                 ranks::Ranks& ranks, const FlickerPictures& take);

/// cdr with its last boundary moved off the field, which it straddles: `cdr-before` cuts nearer than the
/// field, `cdr-behind` farther.
std::vector<depth::NamedTechnique> movedBoundaries();

/// `standard-fitted`: standard with near and far fitted to what is visible, in one cascade. Engines try this
/// first. An object near the camera undoes the gain.
depth::NamedTechnique fittedRange();

} // namespace cdr::experiments
