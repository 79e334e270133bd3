#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/render/frame.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/translucency/sorted_blend.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/render/translucency/weighted_blend.h>

#include <memory>
#include <optional>

namespace cdr::render {

/// Draws a scene's translucent surfaces over its lit opaque ones. It does not depend on targets, depth mapping or
/// depth buffer. A fragment is occluded if the final G-buffer holds a smaller metric view distance. Where
/// sums are weighted, it belongs to the one cascade whose range holds its distance.
class TranslucentPass {
  public:
    /// What one frame slot owns.
    struct Slot {
        TranslucentDraws draws;
        gpu::DescriptorSet surroundings;             ///< of TranslucentFrame
        std::optional<TranslucentShadows> shadows{}; ///< where surfaces receive them
        std::optional<FragmentList> list{};          ///< when sorting
        std::optional<ListRefusal> refusal{};        ///< why this frame is not sorted, though it was to be
        std::uint64_t revision = 0;                  ///< of the scene that it shows
    };

    /// What the scene refers to and the images must outlive the pass. base::RunError when the
    /// device has too little memory for the pass' own images.
    /// @param gbuffer in shader read layout whenever record() is called.
    /// @param lit linear, of kLitFormat, a colour attachment whenever record() is called.
    /// @param variants of materials that have pipelines from the start, beside those of the scene.
    TranslucentPass(const gpu::Device& device, const DrawnScene& scene, const gpu::Image& gbuffer,
                    const gpu::Image& lit, const TranslucencyOptions& options, const Shadows& shadows,
                    const std::vector<std::uint32_t>& variants);

    /// @param shading of the same frame slot, which must outlive this one.
    Slot makeSlot(const ShadingInputs& shading) const;

    /// Where a frame before had no room for its fragments, and lists cannot grow.
    enum class AfterRefusal : std::uint8_t {
        weighted, ///< the next one is drawn weighted too, while the scene is the same
        sorted,   ///< it is tried sorted nonetheless, since it can be drawn again before anybody sees it
    };
    /// Decides what a frame draws; the slot's last frame must have finished.
    /// @param subPixelBits to which vertices are rounded.
    void prepare(Slot& slot, const FrameView& view, AfterRefusal afterRefusal, std::uint32_t subPixelBits,
                 platform::WorkerPool& workers) const;
    /// The next frame is tried sorted.
    void forget() { m_noRoom.reset(); }
    /// Before a frame is drawn again, for what settle() changed. The scene must be that of prepare().
    void prepareAgain(Slot& slot, const FrameView& view, std::uint32_t subPixelBits,
                      platform::WorkerPool& workers) const;
    /// After shading; the lit image stays a colour attachment.
    void record(vk::CommandBuffer primary, Slot& slot) const;
    /// What the frame is drawn with, known before it runs; settle() adds its fragments.
    TranslucencyStats decided(const Slot& slot) const;
    /// After the frame ran. False when its fragments found no room, which the next frame's do.
    bool settle(Slot& slot, TranslucencyStats& stats);

    /// Copies the counts to main memory, if they are counted; the frame's last commands except for
    /// recordHostBarrier().
    void recordReadback(vk::CommandBuffer primary) const;
    /// What they were; empty if they are not counted.
    image::ImageU32 fragmentCounts() const { return m_counter ? m_counter->fetch() : image::ImageU32(); }

  private:
    static Translucency methodOf(const Slot& slot) {
        return slot.list && !slot.refusal ? Translucency::sorted : Translucency::weighted;
    }

    const gpu::Device& m_device;
    DrawnScene m_scene;
    const gpu::Image& m_gbuffer;
    const gpu::Image& m_lit;
    TranslucencyOptions m_options;
    Shadows m_shadows;
    vk::UniqueSampler m_sampler;
    gpu::SetLayout m_surroundingsLayout;
    WeightedBlend m_weighted;
    std::unique_ptr<SortedBlend> m_sorted; ///< where it is asked for and can be
    std::optional<ListRefusal> m_refusal;  ///< why it cannot, where it is asked for
    std::unique_ptr<FragmentCounter> m_counter;
    /// What the last frame was told that had too many fragments, unless a later one found room.
    struct NoRoom {
        ListRefusal refusal;
        std::uint64_t revision = 0; ///< of the scene
    };
    std::optional<NoRoom> m_noRoom;
};

} // namespace cdr::render
