#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/effects.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/shading/fullscreen_pass.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace cdr::render {

/// What shading writes where steps follow that blend or filter: linear light, not yet encoded.
inline constexpr vk::Format kLitFormat = vk::Format::eR16G16B16A16Sfloat;

struct PictureOptions {
    vk::Extent2D extent;
    /// Whether anything comes between shading and the picture; else shading writes the picture itself, and
    /// its format encodes. Antialiasing is such a step.
    bool hasSteps = false;
    bool keepsLinear = false; ///< whether anyone reads lit() afterwards
    Antialias antialias = Antialias::none;
    Finish finish{};                      ///< where there are steps; else shading finishes
    Daylight daylight = Daylight::absent; ///< of the scene
};

/// Whether anything comes between shading and the picture.
bool needsLit(const PictureOptions& options);

/// The sRGB picture of a frame, and where steps follow shading the linear image that they work on.
class Picture {
  public:
    /// @param drawn a picture into which surfaces are drawn lit, of kPictureFormat. It must outlive this, which then has no
    ///        steps. Null: the picture is its own.
    Picture(const gpu::Device& device, const PictureOptions& options, const gpu::Image* drawn = nullptr);

    /// What shading writes and steps change: linear to whoever blends or reads it. Between them in the colour
    /// attachment layout.
    const gpu::Image& lit() const { return m_lit ? m_lit->image : encoded(); }

    /// Takes lit() from colour attachment layout, and leaves encoded() and linear() in transfer source layout.
    void finish(vk::CommandBuffer primary) const;

    /// 8 bits, sRGB.
    const gpu::Image& encoded() const { return m_drawn != nullptr ? *m_drawn : *m_own; }

    /// Linear light that is kept; null where none is.
    const gpu::Image* linear() const { return m_keepsLinear ? &m_lit->image : nullptr; }

    static std::uint64_t predictBytes(const gpu::Device& device, const PictureOptions& options);

  private:
    /// The linear image and the pass that encodes it.
    struct Lit {
        gpu::Image image;
        FullscreenPass pass;
        PassInputs inputs{};
    };
    static std::unique_ptr<Lit> makeLit(const gpu::Device& device, const PictureOptions& options);

    const gpu::Device& m_device;
    const gpu::Image* m_drawn;       ///< else
    std::optional<gpu::Image> m_own; ///< the picture
    std::unique_ptr<Lit> m_lit;      ///< null without steps
    bool m_keepsLinear;
};

} // namespace cdr::render
