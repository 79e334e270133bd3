#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shadows/caster_test.h>
#include <cdr/visibility/mesh_chunks.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// What casters are drawn with.
struct CasterPipelines {
    vk::Pipeline solid;
    vk::Pipeline masked;       ///< of materials that a mask cuts holes into
    vk::PipelineLayout layout; ///< of both; set 0 is DrawKind::textureSet
};

/// What casts shadows in the views of one frame's lights: opaque instances, and what masks keep of others, at the level of
/// detail that the camera sees. Of a closed mesh only the faces towards the light are drawn, of others both sides. Owned by
/// one frame slot.
class CasterDraws {
  public:
    /// What the scene refers to must outlive the draws.
    CasterDraws(const gpu::Device& device, const DrawnScene& scene);

    /// Finds the casters of each view of a frame's lights, gives each LightView::nearAhead, and writes what they are drawn
    /// from. The last frame that drew them must have finished. base::RunError when that needs more memory than there is.
    /// @param slices that LightView::slice counts.
    void prepare(const FrameView& frame, std::span<const ReceiverSlice> slices, std::vector<LightView>& views,
                 platform::WorkerPool& workers);

    std::size_t draws() const { return m_casters.size(); }
    /// Draws those of a view. `commands` is inside a rendering scope, with push constants set.
    void record(vk::CommandBuffer commands, std::size_t view, const CasterPipelines& pipelines) const;

    /// Binding of the records.
    static constexpr std::uint32_t kRecordBinding = 1;

  private:
    /// Which faces of a caster are drawn.
    enum class Faces : std::uint8_t { all, front, mirroredFront };
    /// Of m_casters.
    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    /// Casters that become one draw.
    struct Batch {
        Range casters{};
        std::uint32_t kind = 0; ///< that of one of them, for the mesh, and for the textures if masked
        std::uint8_t level = 0; ///< of detail
        Faces faces = Faces::all;
        bool isMasked = false;
        std::optional<Range> runs{}; ///< of one caster alone: what is drawn of its mesh; else all
    };
    /// What one view shows; ranges begin at 0.
    struct Found {
        std::vector<std::uint32_t> casters;
        std::vector<Batch> batches;
        std::vector<visibility::IndexRun> runs;
    };
    Found find(const visibility::InstanceCells& cells, const FrameView& frame, const ReceiverSlice& slice,
               LightView& view) const;
    std::optional<Range> cut(const Batch& batch, std::uint32_t caster, const LightView& view,
                             const CasterTest& test, std::vector<visibility::IndexRun>& runs) const;
    double roundingOf(std::uint32_t caster, const LightView& view) const;
    const DrawKind& kindOf(std::uint32_t caster) const;
    bool isMasked(std::uint32_t caster) const;
    Batch batchOf(std::uint32_t caster, const FrameView& frame, const LightView& view) const;
    std::uint64_t drawOf(const Batch& batch) const;
    float leastAlphaOf(std::uint32_t caster) const;
    void writeRecords(const LightView& view, const Range& range) const;

    const gpu::Device& m_device;
    DrawnScene m_scene;
    std::vector<std::uint32_t> m_casters; ///< view by view; of a view, batch by batch
    std::vector<Batch> m_batches;         ///< view by view
    std::vector<visibility::IndexRun> m_runs;
    std::vector<Range> m_views; ///< by view, of m_batches
    gpu::Buffer m_records;      ///< of each caster
};

} // namespace cdr::render
