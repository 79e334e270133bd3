#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>

#include <glm/glm.hpp>

#include <cstdint>

namespace cdr::render {

/// One pixel of the geometry buffer: 16 bytes, an image of four 32-bit unsigned integers.
struct CDR_EXPORT GBufferPixel {
    std::uint32_t albedo =
        0; ///< square root of linear, three unorm8; above them metallicRoughnessCode() or occlusion
    std::uint32_t normal = 0; ///< view space, octahedral, two snorm16
    float ahead = 0.0f; ///< view distance beyond the cascade's anchor plane: metric, whatever the mapping
    std::uint32_t idAndCascade = 0; ///< the id in its lowest bits, above it the cascade; 0 is background

    static constexpr std::uint32_t kIdBits = 24;        ///< of idAndCascade that hold the id
    static constexpr std::uint32_t kCascadeMask = 0x3f; ///< after a shift by kIdBits

    /// Object index + 1, 0 for background.
    std::uint32_t id() const { return idAndCascade & ((1u << kIdBits) - 1); }
    /// The cascade that drew it; 0 for background.
    std::uint32_t cascade() const { return (idAndCascade >> kIdBits) & kCascadeMask; }
    /// Unit normal in view space; zero for background.
    glm::vec3 normalView() const;
};
static_assert(sizeof(GBufferPixel) == 16);

} // namespace cdr::render
