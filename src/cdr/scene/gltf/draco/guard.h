#pragma once

#include "stream.h"

#include <cstdint>
#include <optional>
#include <string>

namespace draco {
class PointCloud;
}

namespace cdr::scene::gltf {

/// Says what Draco's decoder may go on with, and keeps why it had to stop. What it looks at is ahead of the decoder.
class DracoGuard {
  public:
    /// Both must outlive this.
    DracoGuard(const DracoStream& stream, const DracoBounds& bounds) : m_stream(stream), m_bounds(bounds) {}

    /// Nothing where the decoder was not stopped here.
    const std::optional<std::string>& reason() const { return m_reason; }

    /// Attributes whose descriptions a buffer stands before, together with those before them.
    bool allowsAttributes(const draco::DecoderBuffer& buffer);
    /// The values of all attributes, which are described by now.
    bool allowsValues(const draco::PointCloud& mesh);
    /// The prediction and the numbers of an attribute that a buffer stands before.
    bool allowsNumbers(const draco::DecoderBuffer& buffer);
    /// Flags of corners that a buffer stands before.
    bool allowsFlags(const draco::DecoderBuffer& buffer);

  private:
    bool stop(std::string reason);

    const DracoStream& m_stream;
    const DracoBounds& m_bounds;
    std::uint32_t m_attributes = 0;
    std::optional<std::string> m_reason;
};

} // namespace cdr::scene::gltf
