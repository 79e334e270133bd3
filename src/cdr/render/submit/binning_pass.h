#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/render/submit/instance_scatter.h>
#include <cdr/shaders/binning_shared.h>
#include <cdr/visibility/level_choice.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::render {

/// A scene's instances on the device, and the compute passes that cull and bin them (shaders/binning/binning.glsl). What changed
/// in the scene reaches them at the start of a frame's commands, by copies and an InstanceScatter. So no frame in flight is
/// waited for.
class BinningPass {
  public:
    /// Storage buffers of the set; the first is the view, the next kSceneBuffers are the scene's.
    static constexpr std::uint32_t kBindings = 14;
    static constexpr std::uint32_t kSceneBuffers = 6;
    using SceneBuffers = std::array<gpu::Buffer, kSceneBuffers>; ///< by binding, from 1 on

    /// base::InputError when the device cannot do it, naming what it lacks. base::RunError, with both
    /// figures, when the scene is too large for its memory or its buffers.
    /// @param drawn whose blended instances are never drawn.
    /// @param detail unless none, an instance whose mesh has levels is a run of its own, so that each draw
    /// may have another level.
    /// @param occlusionLayout of the set that `occluders` and `shown` read; null: they are not asked for.
    BinningPass(const gpu::Device& device, const DrawnScene& drawn, visibility::DetailMode detail,
                const gpu::SetLayout& occlusionLayout);

    /// Groups that count and fill: blocks of shaders::kBinBlock.
    static std::uint64_t blocksOf(std::size_t instances) {
        return (instances + shaders::kBinBlock - 1) / shaders::kBinBlock;
    }

    std::size_t instances() const { return m_looks.size(); }
    std::size_t runs() const { return m_runs.size(); }
    std::span<const GeometryPass::RunGroup> groups() const { return m_groups; }
    const gpu::SetLayout& layout() const { return m_setLayout; }

    /// One frame slot's copies of what changed.
    struct Copies {
        gpu::Buffer staging;
        std::array<std::vector<vk::BufferCopy>, kSceneBuffers> regions;
        std::shared_ptr<const SceneBuffers> buffers; ///< that the slot's set is to name
        InstanceScatter::Slot scattered;
    };
    Copies makeCopies() const {
        return {.staging = {}, .regions = {}, .buffers = {}, .scattered = m_scatter.makeSlot()};
    }
    /// Stages what changed in the scene since the last frame; base::RunError as the constructor. The last frame that
    /// used `copies` must have finished.
    /// @return whether Copies::buffers are others than before.
    bool follow(Copies& copies);
    /// Points the bindings of the scene's buffers at them.
    static void bindScene(const gpu::DescriptorSet& set, const SceneBuffers& buffers);
    /// Copies what follow() staged.
    void recordCopies(vk::CommandBuffer commands, const Copies& copies) const;
    /// Which instances in the frustum are binned.
    enum class Kept : std::uint8_t {
        all,
        occluders, ///< that were seen in the last frame
        shown,     ///< that they do not hide
    };
    /// Runs all four passes; afterwards the lists are ready to be drawn and the result to be read.
    /// @param sets that of the lists, and of occlusion unless all are kept.
    void record(vk::CommandBuffer commands, Kept kept, std::size_t cascades,
                const std::vector<vk::DescriptorSet>& sets) const;
    /// base::RunError, with both figures, where the device does not run as many groups of the passes.
    void requireGroups(std::size_t cascades) const;
    /// The commands with the last copies were submitted, or a host will submit them.
    void noteLaunched() { m_isStaged = false; }
    /// The host does not submit them after all.
    void noteDropped() { m_isStaged = true; }

  private:
    /// How much was grouped.
    struct Grouped {
        std::size_t instances = 0;
        std::size_t runs = 0;
        std::size_t groups = 0;
    };
    /// What follow() finds to be other than on the device.
    struct Changes {
        std::span<const std::uint32_t> instances; ///< by index, of those that were grouped
        Grouped before;                           ///< what is beyond is new
        bool tables = false;                      ///< materials, groups or levels
    };
    struct Tables;
    using SceneSizes = std::array<std::size_t, kSceneBuffers>; ///< bytes
    void groupAll();
    void groupMore();
    void groupInstance(std::size_t i);
    void readInstance(std::size_t i);
    bool readChanged(std::vector<std::uint32_t>& changed);
    SceneSizes sizesNeeded() const;
    bool provideBuffers();
    bool givesRoom(std::uint64_t bytes) const;
    Tables tables() const;
    bool copyChanges(const Changes& changes, Copies& copies) const;
    std::uint64_t listGroups(std::size_t cascades) const; ///< that list commands
    gpu::Pipeline makePipeline(const gpu::Spirv& spirv, const char* name) const;

    const gpu::Device& m_device;
    DrawnScene m_drawn;
    visibility::DetailMode m_detail;
    std::vector<GeometryPass::RunGroup> m_groups;
    // What the device holds, or will once all that is staged was copied.
    std::vector<shaders::InstanceSphere> m_spheres;
    std::vector<shaders::InstanceLook> m_looks;
    std::vector<shaders::KindRun> m_runs;
    std::vector<std::uint32_t> m_kinds; ///< by instance, as they were grouped
    std::uint64_t m_followed = 0;       ///< of the scene's instance changes
    std::uint64_t m_tables = 0;         ///< UploadedScene::tablesRevision()
    std::uint64_t m_meshes = 0;         ///< UploadedScene::meshesRevision()
    std::size_t m_mostCommands = 0;     ///< of a group
    bool m_isStaged = false;            ///< what the last follow() staged may not reach the device
    std::shared_ptr<const SceneBuffers> m_sceneBuffers;
    gpu::SetLayout m_setLayout;
    gpu::PipelineLayout m_layout;
    std::array<gpu::Pipeline, 3> m_count; ///< by Kept
    gpu::Pipeline m_scan;
    gpu::Pipeline m_fill;
    gpu::Pipeline m_commands;
    InstanceScatter m_scatter;
};

} // namespace cdr::render
