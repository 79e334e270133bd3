#include "guard.h"

#include <draco/compression/config/compression_shared.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/point_cloud/point_cloud.h>
#include <fmt/format.h>

#include <utility>

namespace cdr::scene::gltf {

bool DracoGuard::stop(std::string reason) {
    m_reason = std::move(reason);
    return false;
}

bool DracoGuard::allowsAttributes(const draco::DecoderBuffer& buffer) {
    constexpr std::uint32_t kMaxAttributes = 64;
    draco::DecoderBuffer ahead = buffer;
    std::uint32_t count = 0;
    if (!draco::DecodeVarint(&count, &ahead)) {
        return false;
    }
    if (count > kMaxAttributes - m_attributes) {
        return stop(fmt::format("more than {} attributes", kMaxAttributes));
    }
    m_attributes += count;
    return true;
}

bool DracoGuard::allowsValues(const draco::PointCloud& mesh) {
    if (mesh.num_points() != m_bounds.vertices) {
        return stop(
            fmt::format("{} vertices, and its attributes have {}", mesh.num_points(), m_bounds.vertices));
    }
    std::uint64_t bytes = m_stream.connectivityBytes;
    for (int i = 0; i < mesh.num_attributes(); ++i) {
        const draco::PointAttribute& attribute = *mesh.attribute(i);
        const auto components = static_cast<std::uint64_t>(attribute.num_components());
        const auto size = static_cast<std::uint64_t>(draco::DataTypeLength(attribute.data_type()));
        // The values and a copy of them, as integers before; two maps of vertices, their order; flags of corners.
        bytes += m_bounds.vertices * (components * (2 * size + 4) + 16) + 2 * m_bounds.triangles;
    }
    return bytes <= m_bounds.bytes ||
           stop(fmt::format("attributes that would take {} bytes of memory, and {} are left of the limit",
                            bytes, m_bounds.bytes));
}

bool DracoGuard::allowsNumbers(const draco::DecoderBuffer& buffer) {
    draco::DecoderBuffer ahead = buffer;
    std::int8_t method = 0;
    std::int8_t transform = 0;
    std::uint8_t isCompressed = 0;
    if (!ahead.Decode(&method) || (method != draco::PREDICTION_NONE && !ahead.Decode(&transform)) ||
        !ahead.Decode(&isCompressed)) {
        return false;
    }
    // The decoder makes an enumerator of any number.
    if (method != draco::PREDICTION_NONE && (method < 0 || method >= draco::NUM_PREDICTION_SCHEMES)) {
        return stop(fmt::format("a prediction that does not exist ({})", method));
    }
    return isCompressed == 0 || hasBoundedTable(ahead) || stop(kTooLargeTable);
}

bool DracoGuard::allowsFlags(const draco::DecoderBuffer& buffer) {
    draco::DecoderBuffer ahead = buffer;
    std::int32_t count = 0;
    if (!ahead.Decode(&count)) {
        return false;
    }
    return (count >= 0 && static_cast<std::uint64_t>(count) <= 3 * m_bounds.triangles) ||
           stop(fmt::format("{} flags of {} triangles", count, m_bounds.triangles));
}

} // namespace cdr::scene::gltf
