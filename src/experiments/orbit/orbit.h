#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/scene_setup.h>
#include <experiments/pictures/pictures.h>

#include <ranks/ranks.h>
#include <rivals/rival.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::experiments {

/// The zoom of the scene orbit, from a station's window to the numbers of a runway: which technique still
/// reads them.
struct OrbitOptions {
    render::RenderOptions drawing{}; ///< but for the technique; rivals are not snapped
    std::uint32_t frames = 25;       ///< spread evenly over the path, its last among them
    std::vector<depth::NamedTechnique> techniques{depth::presets().begin(), depth::presets().end()};
    bool keepsPictures = true; ///< else OrbitRun::last and OrbitRun::window stay empty: 4 bytes a pixel each
    std::vector<rivals::NamedRival> rivalsBeside{}; ///< measured as the techniques are, behind them
};

/// One technique or rival in one frame.
struct OrbitResult {
    std::uint32_t frame = 0; ///< of the path
    double fovYDegrees = 0.0;
    std::string technique;
    bool isRival = false;
    std::size_t cascades = 0;
    measure::WrongPixels wrong;
};

/// On the first rank; empty on others.
struct OrbitRun {
    std::vector<OrbitResult> results; ///< by frame, then technique, then rival
    std::vector<PictureResult> last;  ///< of the path's last frame, by technique; rivals shade nothing
    image::ImageRgba8
        window; ///< the path's first frame under the last technique; empty where the last alone is drawn
};

/// The frames that are looked at: `count` of a path's `length`, evenly, ascending, the last always.
std::vector<std::uint32_t> zoomFrames(std::uint32_t length, std::uint32_t count);

/// Frames are units of the ranks.
/// @param setup the scene; other scenes with a path do as well. With rivals one that rivals::Contender draws.
/// base::InputError for a rival that the device cannot draw, and for such a scene.
OrbitRun runOrbit(const gpu::Device& device, const scene::SceneSetup& setup, const OrbitOptions& options,
                  const NamedProgress& progress, ranks::Ranks& ranks);

/// A gnuplot script: wrong pixels over the lens, a line per technique.
/// @param measuredOn device and picture, for the title.
std::string orbitPlot(const std::vector<OrbitResult>& results, const std::string& measuredOn);

} // namespace cdr::experiments
