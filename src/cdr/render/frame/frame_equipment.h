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

    /// What is made beside what is there, to take its place.
    struct Made {
        SceneNeeds needs{};
        RenderOptions options{};
        std::unique_ptr<DrawPathFactory> paths; ///< null: they stay
        std::unique_ptr<FramePasses> passes;    ///< refer to the paths
        std::unique_ptr<SlotRing> slots;        ///< refer to paths and passes, so they end first
    };
    /// For a picture of another size.
    Made resized(std::uint32_t width, std::uint32_t height) const;
    /// Nothing may be in flight. Throws nothing.
    void take(Made made);
    /// Makes passes and slots anew for other needs. Nothing may be in flight. Where this throws, all is as it was.
    void follow(const SceneNeeds& needs) { take(make(needs, m_options)); }
    /// Gives all slots room for more lights, as follow().
    void giveLightRoom(std::size_t lights);

  private:
    Made make(const SceneNeeds& needs, const RenderOptions& options) const;
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
