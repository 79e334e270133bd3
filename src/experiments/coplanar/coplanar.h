#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/compare/share.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>

#include <ranks/ranks.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::experiments {

/// What polygon offset is searched over: all pairs of a slope factor and a constant factor.
struct OffsetSettings {
    std::vector<float> slopes{0.0f, 0.25f, 1.0f, 2.0f, 4.0f};
    std::vector<float> constants{0.0f, 1.0f, 4.0f, 16.0f, 64.0f, 256.0f, 1024.0f, 4096.0f};
};

/// Which of two faces at the same place is seen, over random views of the scene `coplanar`. Three ways are compared:
/// nothing is done; Vulkan's depth bias (polygon offset) at the best of many settings; layers in scene units.
struct CoplanarOptions {
    std::uint64_t seed = 2013;
    render::RenderOptions drawing{.width = 320, .height = 180}; ///< but for technique and layers
    std::uint32_t views = 500;                                  ///< each with a second one from 0.01 aside
    std::uint32_t searchViews = 24; ///< that settings of polygon offset are compared over
    OffsetSettings offsets;
    std::vector<depth::NamedTechnique> techniques{depth::presets().begin(), depth::presets().end()};
};

/// What decides between faces at the same place.
enum class CoplanarMethod : std::uint8_t {
    none,          ///< nothing: as they come
    polygonOffset, ///< Vulkan's depth bias at the best of many settings
    layers,        ///< layer offsets, in scene units
};
inline constexpr std::array kCoplanarMethods{CoplanarMethod::none, CoplanarMethod::polygonOffset,
                                             CoplanarMethod::layers};
/// "none", "polygon offset" or "layers".
std::string_view nameOf(CoplanarMethod method);

/// One technique and method over all views. Pixels are inner ones (measure::WrongPixels).
struct CoplanarResult {
    std::string technique{};
    CoplanarMethod method = CoplanarMethod::none;
    render::LayerOptions layers{}; ///< how it was drawn
    std::uint64_t pixels = 0;
    std::uint64_t wrong = 0; ///< that show another object than the truth, coverage differences left out
    /// Coverage differences: what is shown touches the pixel's centre because the device rounds vertices, and only then.
    std::uint64_t coverage = 0;
    std::uint64_t wrongViews = 0; ///< with any
    std::uint64_t through = 0;    ///< that show what lies behind the thin wall
    std::uint64_t flips =
        0; ///< from a view to its second one, measure::countFlips(), coverage differences included
    std::uint64_t coverageFlips = 0; ///< of those: where either view has a coverage difference
    image::ImageRgba8
        picture{}; ///< heat map of the view with the most wrong pixels; empty where there is none

    /// Wrong pixels of all; none where there are none to judge by.
    std::optional<double> wrongShare() const { return measure::shareOf(wrong, pixels); }
};

/// By technique, then by method; counts and pictures are the first rank's, which share techniques and then views.
/// base::InputError for no views or no setting of polygon offset.
std::vector<CoplanarResult> runCoplanar(const gpu::Device& device, const CoplanarOptions& options,
                                        const Progress& progress, ranks::Ranks& ranks);

} // namespace cdr::experiments
