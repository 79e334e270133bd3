#pragma once

#include <cdr/render/geometry/facet_meshes.h>
#include <cdr/render/geometry/facet_pipelines.h>
#include <cdr/render/uploaded_scene.h>

namespace cdr::render {

/// What the draws of one technique are recorded with by facets: into a visibility buffer, into the picture, or for depth alone.
struct FacetPass {
    const UploadedScene& uploaded; ///< must outlive the pass
    FacetMeshes meshes; ///< may become others of a world's scene, which are drawn from the next frame on
    FacetPipelines pipelines;

    /// Whether facets are lit while they are drawn; else each has a record.
    bool lights() const { return pipelines.options().output == GeometryOutput::lit; }
};

} // namespace cdr::render
