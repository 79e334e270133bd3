#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <cdr/scene/scene_setup.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cdr::experiments {

/// Models as the renderer shows them, compared with a float64 reference that shares no code with it.
struct ModelsOptions {
    render::RenderOptions drawing{.width = 640, .height = 360}; ///< but for translucency
    bool closer = true; ///< narrows the lens until the model fills the picture
};

/// Pictures of each model that a ModelResult holds.
inline constexpr std::size_t kModelPictures = 4;

/// One model.
struct ModelResult {
    std::string model; ///< the name of its pictures; compareModel() has the scene's
    std::string light;
    std::uint64_t triangles = 0; ///< of what is drawn, repeats counted
    std::uint64_t textures = 0;
    double coveredFraction = 0.0;        ///< of the pixels: those that show a surface, opaque or blended
    double flip = 0.0;                   ///< mean FLIP over the picture
    std::optional<double> coveredFlip{}; ///< mean FLIP over the covered pixels; none where there are none
    /// Over covered inner pixels: mean of the largest channel's difference, 8-bit steps. None where there are none.
    std::optional<double> meanSteps{};
    image::ImageRgba8 plain{}; ///< base colour and the factors of metallic and roughness alone
    image::ImageRgba8 picture{};
    image::ImageRgba8 reference{};
    image::ImageRgba8 difference{}; ///< FLIP of each pixel, from black to white
};

/// @param plain the same model, lit for a picture of base colour alone.
/// @param light that `model` was opened with: under a sky both pictures are tone mapped.
/// base::InputError as measure::castLayers().
ModelResult compareModel(const gpu::Device& device, const scene::SceneSetup& model,
                         const scene::SceneSetup& plain, scene::ModelLight light,
                         const ModelsOptions& options);

} // namespace cdr::experiments
