#pragma once

#include "byte_source.h"
#include "read_progress.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cdr::scene::gltf {

/// The blocks of open files that were used last. Elements are read one by one, from several places of a file in turn, and
/// none of these parts need be in memory whole. The files must outlive it. Not for two threads at a time.
class BlockCache {
  public:
    static constexpr std::size_t kBlockBytes = std::size_t{16} << 10;
    static constexpr std::size_t kBytes = std::size_t{32} << 20; ///< of all blocks
    /// Most bytes that are asked for at a time: a MAT4 of the widest components.
    static constexpr std::size_t kMaxBytes = 128;

    struct Block;
    /// Where a reader found its last block, null at first: it likely needs the same one next.
    using Hint = const Block*;

    /// `length` bytes of a file, at most kMaxBytes, until the next call. All must have been in it when it was opened.
    const std::uint8_t* at(const OpenFile& file, std::uint64_t offset, std::size_t length, Hint& hint) {
        const std::size_t within = offset % kBlockBytes;
        if (hint != nullptr && hint->number == offset / kBlockBytes && hint->file == &file &&
            within + length <= kBlockBytes) {
            return hint->bytes + within;
        }
        return find(file, offset, length, hint);
    }

    /// Tells `progress` of all bytes that are read from now on; null: nothing more. It must outlive this, or the next call.
    void tell(ReadProgress* progress) { m_progress = progress; }

    /// A place for a block.
    struct Block {
        const OpenFile* file = nullptr; ///< null: it holds nothing
        std::uint64_t number = 0;       ///< in the file
        std::uint64_t lastUse = 0;
        std::uint8_t* bytes = nullptr;
    };

  private:
    static constexpr std::size_t kBlocks = kBytes / kBlockBytes;
    static constexpr std::size_t kBlocksOfSet = 8; ///< a block has as many places where it may be

    void allocate();
    const std::uint8_t* find(const OpenFile& file, std::uint64_t offset, std::size_t length, Hint& hint);
    const Block& blockAt(const OpenFile& file, std::uint64_t number);

    std::vector<Block> m_blocks; ///< empty until a file is read; then they stay where they are
    std::unique_ptr<std::uint8_t[]>
        m_bytes{}; ///< of all blocks; the system gives memory to those that are used
    std::uint64_t m_uses = 0;
    ReadProgress* m_progress = nullptr;
    std::array<std::uint8_t, kMaxBytes> m_joined{}; ///< of two blocks
};

} // namespace cdr::scene::gltf
