#pragma once

#include <cdr/render/drawn_scene.h>
#include <cdr/render/geometry/facet_meshes.h>
#include <cdr/render/render_options.h>

#include <optional>

namespace cdr::render {

/// The meshes to draw by facets, into a visibility buffer or lit into the picture. Empty for a G-buffer. base::InputError,
/// with the reason, where one of these is asked for and cannot be used.
std::optional<FacetMeshes> chooseFacets(const DrawnScene& drawn, const RenderOptions& options);

/// base::InputError, with the reason, where the scene has become one that facets do not do for.
void requireFacets(const DrawnScene& drawn, const RenderOptions& options, const FacetMeshes& facets);

} // namespace cdr::render
