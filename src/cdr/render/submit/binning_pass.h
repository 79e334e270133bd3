#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/visibility/level_choice.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// A scene's instances on the device, and the compute passes that cull and bin them (shaders/binning.glsl).
/// Immutable; every frame slot brings a BinningSlot of its own.
class BinningPass {
  public:
    /// base::InputError when the device cannot do it, naming what it lacks; base::RunError, with both
    /// figures, when the scene is too large for its memory or its buffers.
    /// @param drawn whose blended instances are never drawn.
    /// @param detail unless none, an instance whose mesh has levels is a run of its own, so that each draw
    /// may have another level.
    BinningPass(const gpu::Device& device, const DrawnScene& drawn, visibility::DetailMode detail);

    std::size_t instances() const { return m_instances; }
    std::size_t runs() const { return m_runs; }
    std::span<const GeometryPass::RunGroup> groups() const { return m_groups; }
    vk::DescriptorSetLayout layout() const { return *m_setLayout; }

    /// Points the bindings of what never changes at the scene's buffers.
    void bindScene(vk::DescriptorSet set) const;
    /// Runs all four passes; afterwards the lists are ready to be drawn and the result to be read.
    void record(vk::CommandBuffer commands, vk::DescriptorSet set, std::size_t cascades) const;

    /// Storage buffers of the set; the first is the view, the next kSceneBuffers are the scene's.
    static constexpr std::uint32_t kBindings = 14;
    static constexpr std::uint32_t kSceneBuffers = 6;

  private:
    void uploadInstances(const DrawnScene& drawn, visibility::DetailMode detail);
    vk::UniquePipeline makePipeline(std::span<const std::uint32_t> spirv, const char* name) const;

    const gpu::Device& m_device;
    std::size_t m_instances = 0;
    std::size_t m_runs = 0;
    std::vector<GeometryPass::RunGroup> m_groups;
    std::array<gpu::Buffer, kSceneBuffers> m_sceneBuffers; ///< by binding, from 1 on
    vk::UniqueDescriptorSetLayout m_setLayout;
    vk::UniquePipelineLayout m_layout;
    vk::UniquePipeline m_count;
    vk::UniquePipeline m_scan;
    vk::UniquePipeline m_fill;
    vk::UniquePipeline m_commands;
};

} // namespace cdr::render
