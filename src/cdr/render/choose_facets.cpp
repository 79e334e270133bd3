#include <cdr/base/format_error.h>
#include <cdr/render/choose_facets.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/shaders/shared.h>

#include <algorithm>

namespace cdr::render {

namespace {

/// Why surfaces cannot be lit while they are drawn, beside why facets do not do; null where they can.
const char* litRefusalOf(const DrawnScene& drawn, const RenderOptions& options) {
    if (hasLayers(options.targets.kind)) {
        return "it draws into the picture, so targets must be single or one-pass";
    }
    if (options.effects.fog.visibility > 0.0 || options.effects.antialias != Antialias::none) {
        return "fog and antialiasing work on surfaces that are shaded later";
    }
    if (options.linear) {
        return "colours go straight into the picture, so no linear light is kept";
    }
    if (options.shadows.isOn()) {
        return "shadows fall on surfaces that are shaded later";
    }
    if (preparedSurfaces(drawn.uploaded, options.prepareFor).kept.metallicRoughness) {
        return "it draws matt surfaces";
    }
    if (drawn.scene.sky || drawn.scene.air) {
        return "it knows no sky and no air";
    }
    if (std::max(lightFormOf(drawn.scene), options.prepareFor.lights) > shaders::kPushedLights ||
        options.prepareFor.shapedLights) {
        return "it takes at most two lights, without cones and ranges";
    }
    return nullptr;
}

/// Why facets do not do; null where they do, as far as options tell.
const char* refusalOf(const DrawnScene& drawn, const RenderOptions& options) {
    if (options.submission == Submission::gpuDriven) {
        return "its triangles are written by the CPU, not gpu-driven";
    }
    if (options.batching != Batching::instanced) {
        return "it draws many objects by one command, so the batching must be instanced";
    }
    if (options.snapping == Snapping::inPlane) {
        return "its facets share corners, so the device must round them: snapping by-device";
    }
    if (options.effects.occlusion.radius > 0.0) {
        return "ambient occlusion reads the G-buffer";
    }
    if (options.focus.isOn()) {
        return "a lens with a focus reads the G-buffer";
    }
    const PreparedSurfaces prepared = preparedSurfaces(drawn.uploaded, options.prepareFor);
    if (prepared.blended) {
        return "blended surfaces read the G-buffer";
    }
    if (prepared.kept.emission) {
        return "surfaces that emit light, or have an occlusion texture, read the G-buffer";
    }
    if (!drawn.uploaded.hasHostVertices()) {
        return "its triangles are written by the CPU, which lacks the vertices of meshes that the device deforms";
    }
    if (drawn.uploaded.hasLayers()) {
        return "materials with a layer offset set their depth per pixel";
    }
    return nullptr;
}

[[noreturn]] void refuse(SurfacePath surface, const char* why) {
    throw base::inputError("surface {} cannot be used: {}", nameOf(surface), why);
}

} // namespace

std::optional<FacetMeshes> chooseFacets(const DrawnScene& drawn, const RenderOptions& options) {
    if (options.surface == SurfacePath::gbuffer) {
        return std::nullopt;
    }
    FacetMeshes facets = FacetMeshes::of(drawn.scene, drawn.uploaded);
    requireFacets(drawn, options, facets);
    return facets;
}

void requireFacets(const DrawnScene& drawn, const RenderOptions& options, const FacetMeshes& facets) {
    if (const char* refusal = refusalOf(drawn, options)) {
        refuse(options.surface, refusal);
    }
    const char* ofLight = options.surface == SurfacePath::lit ? litRefusalOf(drawn, options) : nullptr;
    if (ofLight != nullptr) {
        refuse(options.surface, ofLight);
    }
    if (!facets.suffice(drawn.scene, drawn.uploaded)) {
        refuse(
            options.surface,
            "a mesh is not made of a few plane faces of one colour, or a material is textured, masked or double-sided");
    }
}

} // namespace cdr::render
