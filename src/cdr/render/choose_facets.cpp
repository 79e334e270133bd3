#include <cdr/base/error.h>
#include <cdr/render/choose_facets.h>
#include <cdr/render/renderer_setup.h>

#include <fmt/format.h>

namespace cdr::render {

namespace {

/// Why a visibility buffer does not do; null where it does, as far as options tell.
const char* refusalOf(const DrawnScene& drawn, const RenderOptions& options) {
    if (options.submission == Submission::gpuDriven) {
        return "its triangles are written by the CPU, not gpu-driven";
    }
    if (options.batching != Batching::instanced) {
        return "it draws many objects by one command, so the batching must be instanced";
    }
    if (options.effects.occlusion.radius > 0.0) {
        return "ambient occlusion reads the G-buffer";
    }
    if (options.focus.isOn()) {
        return "a lens with a focus reads the G-buffer";
    }
    const PreparedSurfaces prepared = preparedSurfaces(options.prepareFor);
    if (drawn.uploaded.hasBlended() || prepared.blended) {
        return "blended surfaces read the G-buffer";
    }
    if (drawn.uploaded.hasEmission() || prepared.emission) {
        return "surfaces that emit light, or have an occlusion texture, read the G-buffer";
    }
    if (drawn.uploaded.hasLayers()) {
        return "materials with a layer set their depth per pixel";
    }
    return nullptr;
}

[[noreturn]] void refuse(const char* why) {
    throw base::InputError(fmt::format("surface visibility cannot be used: {}", why));
}

} // namespace

std::optional<FacetMeshes> chooseFacets(const DrawnScene& drawn, const RenderOptions& options) {
    if (options.surface != SurfacePath::visibility) {
        return std::nullopt;
    }
    FacetMeshes facets = FacetMeshes::of(drawn.scene, drawn.uploaded);
    requireFacets(drawn, options, facets);
    return facets;
}

void requireFacets(const DrawnScene& drawn, const RenderOptions& options, const FacetMeshes& facets) {
    if (const char* refusal = refusalOf(drawn, options)) {
        refuse(refusal);
    }
    if (!facets.suffice(drawn.scene, drawn.uploaded)) {
        refuse(
            "a mesh is not made of a few plane faces of one colour, or a material is textured, masked or double-sided");
    }
}

} // namespace cdr::render
