#include <cdr/render/submit/stager.h>

#include <algorithm>

namespace cdr::render {

void Stager::add(const Piece& piece) {
    if (!piece.bytes.empty()) {
        m_pieces.push_back(piece);
        m_bytes += piece.bytes.size();
    }
}

void Stager::write(const gpu::Device& device, gpu::Buffer& staging,
                   std::span<std::vector<vk::BufferCopy>> regions) const {
    if (isEmpty()) {
        staging = {}; // a scene that stands still keeps no copy of itself
        return;
    }
    if (staging.size() < m_bytes) {
        const std::size_t room =
            gpu::roomToGrow(device, {.count = m_bytes, .most = device.info().maxBufferBytes},
                            gpu::MemoryUse::hostWrites, "changes of a gpu-driven scene");
        staging = gpu::Buffer(device, room, vk::BufferUsageFlagBits::eTransferSrc, gpu::MemoryUse::hostWrites,
                              "binning changes");
    }
    std::size_t end = 0;
    for (const Piece& piece : m_pieces) {
        std::copy(piece.bytes.begin(), piece.bytes.end(), static_cast<std::byte*>(staging.mapped()) + end);
        regions[piece.buffer].push_back(
            {.srcOffset = end, .dstOffset = piece.offset, .size = piece.bytes.size()});
        end += piece.bytes.size();
    }
    staging.flush();
}

} // namespace cdr::render
