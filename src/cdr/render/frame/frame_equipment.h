#pragma once

#include <cdr/render/frame/frame_passes.h>
#include <cdr/render/frame/slot_ring.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::render {

/// What a renderer draws with: draw paths, passes and slots, made for its options and for what its scene needs.
class FrameEquipment {
  public:
    /// The device, the scene and the workers must outlive it. base::InputError and base::RunError as Renderer.
    FrameEquipment(const gpu::Device& device, const DrawnScene& drawn, platform::WorkerPool& workers,
                   const RenderOptions& options);

    const RenderOptions& options() const { return m_options; }
    const SceneNeeds& needs() const { return m_needs; }
    DrawPathFactory& paths() const { return *m_paths; }
    FramePasses& passes() const { return *m_passes; }
    SlotRing& slots() const { return *m_slots; }

    /// Makes passes and slots anew for other needs. Nothing may be in flight. Where this throws, all is as it was.
    void follow(const SceneNeeds& needs) { remake(needs, m_options); }
    /// The same for a picture of another size.
    void resize(std::uint32_t width, std::uint32_t height);
    /// Gives all slots room for more lights, as follow().
    void giveLightRoom(std::size_t lights);

  private:
    void remake(const SceneNeeds& needs, const RenderOptions& options);
    std::unique_ptr<DrawPathFactory> makePaths(const SceneNeeds& needs, const RenderOptions& options) const;
    std::unique_ptr<SlotRing> makeSlots(const RenderOptions& options, const DrawPathFactory& paths,
                                        const FramePasses& passes) const;

    const gpu::Device& m_device;
    const DrawnScene& m_drawn;
    platform::WorkerPool& m_workers;
    RenderOptions m_options;
    SceneNeeds m_needs;
    std::unique_ptr<DrawPathFactory> m_paths;
    std::unique_ptr<FramePasses> m_passes; ///< refer to the paths
    std::unique_ptr<SlotRing> m_slots;     ///< refer to paths and passes
};

} // namespace cdr::render
