#include "block_cache.h"

#include <algorithm>
#include <span>

namespace cdr::scene::gltf {

namespace {

/// Spreads the blocks of all files evenly.
std::size_t setOf(const OpenFile& file, std::uint64_t number, std::size_t sets) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
    const std::uint64_t key = number + reinterpret_cast<std::uintptr_t>(&file);
    return static_cast<std::size_t>(((key * kGolden) >> 32u) % sets);
}

} // namespace

const std::uint8_t* BlockCache::find(const OpenFile& file, std::uint64_t offset, std::size_t length,
                                     Hint& hint) {
    const std::uint64_t number = offset / kBlockBytes;
    const std::size_t within = offset % kBlockBytes;
    hint = &blockAt(file, number);
    const std::size_t inFirst = std::min(length, kBlockBytes - within);
    if (inFirst == length) {
        return hint->bytes + within;
    }
    std::copy_n(hint->bytes + within, inFirst, m_joined.data());
    hint = &blockAt(file, number + 1); // may take the place of the first one
    std::copy_n(hint->bytes, length - inFirst, m_joined.data() + inFirst);
    return m_joined.data();
}

void BlockCache::allocate() {
    m_bytes = std::make_unique_for_overwrite<std::uint8_t[]>(kBytes);
    m_blocks.resize(kBlocks);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        m_blocks[i].bytes = m_bytes.get() + i * kBlockBytes;
    }
}

const BlockCache::Block& BlockCache::blockAt(const OpenFile& file, std::uint64_t number) {
    if (m_blocks.empty()) {
        allocate();
    }
    const std::size_t first = setOf(file, number, kBlocks / kBlocksOfSet) * kBlocksOfSet;
    Block* oldest = &m_blocks[first];
    for (Block& block : std::span(m_blocks).subspan(first, kBlocksOfSet)) {
        if (block.file == &file && block.number == number) {
            block.lastUse = ++m_uses;
            return block;
        }
        oldest = block.lastUse < oldest->lastUse ? &block : oldest;
    }
    oldest->file = nullptr; // it holds nothing if reading fails
    const std::uint64_t offset = number * kBlockBytes;
    const auto length =
        static_cast<std::size_t>(std::min<std::uint64_t>(kBlockBytes, file.file.size() - offset));
    readOpen(file, offset, {oldest->bytes, length});
    *oldest = {.file = &file, .number = number, .lastUse = ++m_uses, .bytes = oldest->bytes};
    if (m_progress != nullptr) {
        m_progress->read(length);
    }
    return *oldest;
}

} // namespace cdr::scene::gltf
