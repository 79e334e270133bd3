#pragma once

#include <cdr/gpu/memory.h>

#include <vulkan/vulkan.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cdr::render {

/// The geometry buffer: what shading, picking and effects read. 16 bytes per pixel.
class GBuffer {
  public:
    /// In the order of the fragment shader's outputs.
    enum Attachment : std::size_t {
        albedo, ///< sRGB; alpha 0 marks unlit
        normal, ///< view space, octahedral, two snorm16 in a uint
        ahead,  ///< float32, view distance beyond the cascade's anchor plane: metric, whatever the mapping
        id,     ///< object index + 1 and the cascade, shaders::kIdBits; 0 is background
        kAttachments
    };

    /// How the images are made to be seen.
    enum class Views {
        typed,        ///< as what they hold
        typedAndBits, ///< and, for merging without a bit changed, as plain R32_UINT: gpu::Image::aliasView()
    };
    GBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name,
            Views views = Views::typed);

    const gpu::Image& image(Attachment attachment) const { return m_images[attachment]; }
    const std::array<gpu::Image, kAttachments>& images() const { return m_images; }

    static std::vector<vk::Format> formats();
    /// The format of the images' alias views.
    static constexpr vk::Format kBitsFormat = vk::Format::eR32Uint;
    static std::uint64_t predictBytes(vk::Extent2D extent);

  private:
    std::array<gpu::Image, kAttachments> m_images;
};

/// A depth attachment of the technique's format.
gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, vk::Format format,
                           const std::string& name);
std::uint64_t predictDepthBytes(vk::Extent2D extent, vk::Format format);

} // namespace cdr::render
