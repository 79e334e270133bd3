#pragma once

#include <cdr/render/render_options.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/uploaded_scene.h>

namespace cdr::render {

/// What RenderOptions come to, for the renderer's own use.

/// base::InputError for options that no device and no scene allow together.
void requireCompatible(const RenderOptions& options);

/// The picture's size. base::InputError for options that cannot be, base::RunError, with both figures, when
/// the picture's memory does not suffice.
vk::Extent2D checkedExtent(const gpu::Device& device, const RenderOptions& options, const SceneTraits& scene);

/// Device bytes of a picture and what it is drawn through: with a visibility buffer also the G-buffer that is resolved
/// from it.
std::uint64_t predictPictureBytes(const gpu::Device& device, const RenderOptions& options,
                                  const SceneTraits& scene);

/// @param daylight of the scene; it changes no size.
PictureOptions pictureOptions(vk::Extent2D extent, const RenderOptions& options, const SceneTraits& scene,
                              Daylight daylight = Daylight::absent);
/// Without emission.
TargetsOptions targetsOptions(vk::Extent2D extent, vk::Format format, const RenderOptions& options);

/// What surfaces keep for shading beside the G-buffer's colour, normal, distance and id.
struct KeptSurfaces {
    bool metallicRoughness = false; ///< GeometryOptions::metallicRoughness
    bool emission = false;          ///< GeometryOptions::emission
    bool operator==(const KeptSurfaces&) const = default;
};

/// What a renderer is prepared for: by its scene, by PrepareFor, and by the materials in that.
struct PreparedSurfaces {
    KeptSurfaces kept{};
    bool blended = false;
};
PreparedSurfaces preparedSurfaces(const UploadedScene& uploaded, const PrepareFor& prepared);

/// Whether frames show metallic and roughness; else FrameStats::lostMetallicRoughness says so where a surface has them.
bool keepsMetallicRoughness(const RenderOptions& options);

/// Whether frames show what surfaces emit; else FrameStats::lostEmission says so where a surface does.
bool keepsEmission(const RenderOptions& options);

/// To which vertices are rounded, by the device or by RenderOptions::snapBits.
std::uint32_t subPixelBits(const gpu::Device& device, const RenderOptions& options);

} // namespace cdr::render
