#pragma once

#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/shadows/shadow_flips.h>
#include <cdr/measure/shadows/wrong_shadows.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/scene_setup.h>
#include <experiments/progress.h>

#include <options/camera_options.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Rendered shadows against float64 rays to the lights.
struct ShadowExperiment {
    std::vector<depth::NamedTechnique> techniques{depth::namedTechnique("anchored")};
    std::vector<render::ShadowMethod> methods{render::ShadowMethod::anchored};
    render::RenderOptions options; ///< the technique and the method are set
};

/// A light in a frame of a technique.
struct ShadowResult {
    std::string technique;
    std::string method;
    std::uint32_t frame = 0;
    std::size_t light = 0;       ///< index into Scene::lights
    std::size_t channel = 0;     ///< of that light in Frame::litMask
    measure::WrongShadows wrong; ///< of the frame
    /// Since the frame before; empty for the first.
    std::optional<measure::FlipCount> flips{};
    std::size_t maps = 0;      ///< that the frame drew, of all lights
    std::size_t casters = 0;   ///< draws into those
    double executeMs = 0.0;    ///< of the frame
    image::ImageRgba8 picture; ///< as rendered
    image::ImageRgba8 heatMap; ///< measure::shadowHeatMap()
};

/// Results go out as they come, by technique, frame and light. base::InputError for a scene
/// without lights, and a method that casts none.
void runShadows(const gpu::Device& device, const scene::SceneSetup& setup,
                const options::FrameCameras& cameras, const ShadowExperiment& experiment,
                const Progress& progress, const std::function<void(const ShadowResult&)>& take);

} // namespace cdr::experiments
