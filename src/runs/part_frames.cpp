#include "part_frames.h"

#include <cdr/base/error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace cdr::runs {

namespace {

/// Pixels without a surface, then pixels with one, in the order of the raster. The latter follow, then their colours.
struct RunOfPixels {
    std::uint32_t background = 0;
    std::uint32_t surfaces = 0;
};

template <typename Value>
void append(platform::Bytes& bytes, const Value* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* begin = reinterpret_cast<const std::uint8_t*>(values);
    bytes.insert(bytes.end(), begin, begin + count * sizeof(Value));
}

/// Reads values off the front of bytes.
class Reader {
  public:
    explicit Reader(const platform::Bytes& bytes) : m_bytes(bytes) {}

    bool isAtEnd() const { return m_at == m_bytes.size(); }

    template <typename Value>
    std::vector<Value> read(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (count > (m_bytes.size() - m_at) / sizeof(Value)) {
            throw base::RunError("a rank's part of a frame ends too early");
        }
        std::vector<Value> values(count);
        if (count > 0) {
            std::memcpy(values.data(), m_bytes.data() + m_at, count * sizeof(Value));
        }
        m_at += count * sizeof(Value);
        return values;
    }

  private:
    const platform::Bytes& m_bytes;
    std::size_t m_at = 0;
};

} // namespace

platform::Bytes packedSurfaces(const render::Frame& frame) {
    const auto& pixels = frame.gbuffer.pixels;
    const auto shows = [&](std::size_t pixel) { return pixels[pixel].id() != 0; };
    platform::Bytes bytes;
    for (std::size_t begin = 0, end = 0; begin < pixels.size(); begin = end) {
        std::size_t surface = begin;
        while (surface < pixels.size() && !shows(surface)) {
            ++surface;
        }
        for (end = surface; end < pixels.size() && shows(end);) {
            ++end;
        }
        const RunOfPixels run{.background = static_cast<std::uint32_t>(surface - begin),
                              .surfaces = static_cast<std::uint32_t>(end - surface)};
        append(bytes, &run, 1);
        append(bytes, pixels.data() + surface, run.surfaces);
        append(bytes, frame.color.pixels.data() + surface, run.surfaces);
    }
    return bytes;
}

void layUnder(render::Frame& frame, const platform::Bytes& farther) {
    Reader reader(farther);
    std::size_t pixel = 0;
    while (!reader.isAtEnd()) {
        const RunOfPixels run = reader.read<RunOfPixels>(1).front();
        const auto surfaces = reader.read<render::GBufferPixel>(run.surfaces);
        const auto colors = reader.read<image::Rgba8>(run.surfaces);
        pixel += run.background;
        if (pixel + run.surfaces > frame.gbuffer.pixels.size()) {
            throw base::RunError("a rank's part of a frame is larger than the picture");
        }
        for (std::size_t i = 0; i < run.surfaces; ++i, ++pixel) {
            if (frame.gbuffer.pixels[pixel].id() == 0) {
                frame.gbuffer.pixels[pixel] = surfaces[i];
                frame.color.pixels[pixel] = colors[i];
            }
        }
    }
}

void mergeParts(ranks::Ranks& ranks, render::Frame& frame, std::size_t& bytesSent) {
    ranks.merge(
        [&] {
            platform::Bytes packed = packedSurfaces(frame);
            bytesSent += packed.size();
            return packed;
        },
        [&](const platform::Bytes& later) { layUnder(frame, later); });
}

} // namespace cdr::runs
