#pragma once

#include <cdr/render/submit/binning_pass.h>

#include <array>

namespace cdr::render {

/// Where the passes of BinningPass put one frame's draws: lists on the device, their descriptor set, and what the CPU is
/// told. Of one frame slot.
class DeviceLists {
  public:
    DeviceLists(const gpu::Device& device, const BinningPass& binning);

    /// Makes room and writes what the passes read. base::RunError where a list needs too much memory.
    void prepare(const FrameView& view, depth::Mapping mapping);
    /// Once the passes ran. Null where records had too little room, which they now have. base::RunError where a list of
    /// as many needs too much memory: the lists stay as they are.
    const shaders::BinningResult* settle();

    const gpu::DescriptorSet& set() const { return m_set; }
    const GeometryPass::IndirectDraws& draws() const { return m_draws; }

  private:
    enum List : std::size_t { landings, blockDraws, runFirsts, records, commands, counts, kLists };
    void growLists(std::size_t cascades);
    void growRecords(std::size_t draws);
    void grow(List list, std::size_t bytes);

    const gpu::Device& m_device;
    const BinningPass& m_binning;
    gpu::Buffer m_view;
    gpu::Buffer m_result;
    std::array<gpu::Buffer, kLists> m_lists; ///< bindings from kFirstList on
    std::size_t m_recordCapacity = 0;
    gpu::DescriptorSet m_set;
    GeometryPass::IndirectDraws m_draws;
};

} // namespace cdr::render
