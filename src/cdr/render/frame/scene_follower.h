#pragma once

#include <cdr/render/drawn_scene.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/render_options.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::render {

class DrawPathFactory;

/// The scene that a renderer draws, and how much of its changes the renderer has taken over.
class SceneFollower {
  public:
    /// For a scene that does not change. base::InputError for the GpuScene of another scene, of a world, or on another device
    /// than this one.
    SceneFollower(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene);
    /// For a world, which it updates, so that what is made from it is up to date. base::InputError for a GpuScene on another
    /// device.
    SceneFollower(const gpu::Device& device, GpuScene& live);

    const DrawnScene& drawn() const { return m_drawn; }
    /// Motion is worked out: a world keeps the vertices that meshes had before, until this ends.
    void keepLastVertices();

    /// Uploads what changed in a world.
    void update();
    /// Whether draws must learn of new materials, meshes or kinds since the last noteFollowed().
    bool isChanged() const { return m_revision != m_drawn.uploaded.revision(); }
    /// Makes the facets anew if meshes, materials or kinds changed. base::InputError where facets no longer do.
    void followFacets(DrawPathFactory& paths, const RenderOptions& options);
    /// All changes up to the last update() have been taken over.
    void noteFollowed() { m_revision = m_drawn.uploaded.revision(); }

    /// Of the scene, as noteFollowed() found it.
    std::uint64_t revision() const { return m_revision; }
    /// Whether a frame of a revision shows the scene as it is now.
    bool isCurrent(std::uint64_t revision) const {
        return m_drawn.uploaded.isCurrent() && revision == m_drawn.uploaded.revision();
    }

  private:
    /// What facets were made from.
    struct FacetsMadeFrom {
        std::uint64_t meshesRevision = 0;
        std::size_t kinds = 0;

        bool operator==(const FacetsMadeFrom&) const = default;
    };

    GpuScene* m_live; ///< null for a scene that stays as it is
    DrawnScene m_drawn;
    std::uint64_t m_revision;
    FacetsMadeFrom m_facetsMadeFrom;
    std::shared_ptr<const void> m_lastVertices; ///< null where they need not be kept
};

} // namespace cdr::render
