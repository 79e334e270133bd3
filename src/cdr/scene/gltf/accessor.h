#pragma once

#include "bytes/files.h"
#include "component.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>

namespace cdr::scene::gltf {

/// Elements at even distances inside a buffer; by default elements that are zero.
class Strided {
  public:
    Strided() = default;
    /// In memory that outlives this.
    Strided(const std::uint8_t* first, std::size_t stride) : m_first(first), m_stride(stride) {}
    /// @param bytes that others own or keep open longer than this. @param blocks must outlive this.
    Strided(const ByteSource& bytes, std::size_t stride, BlockCache& blocks)
        : m_first(bytes.inMemory()),
          m_stride(stride),
          m_file(bytes.file()),
          m_offset(bytes.offsetInFile()),
          m_blocks(&blocks) {}

    bool isThere() const { return m_first != nullptr || m_file != nullptr; }
    /// From one element to the next in a file, 0 if they are in memory.
    std::size_t bytesApartInFile() const { return m_file != nullptr ? m_stride : 0; }
    /// The bytes of an element of `length`, until those of another one are asked for.
    const std::uint8_t* at(std::size_t i, std::size_t length) const {
        return m_file == nullptr ? m_first + i * m_stride
                                 : m_blocks->at(*m_file, m_offset + i * m_stride, length, m_hint);
    }

  private:
    const std::uint8_t* m_first = nullptr;
    std::size_t m_stride = 0;
    const OpenFile* m_file = nullptr;
    std::uint64_t m_offset = 0;
    BlockCache* m_blocks = nullptr;
    mutable BlockCache::Hint m_hint = nullptr;
};

/// One accessor. Every byte that its elements can touch was checked to lie inside its buffer. They are read when they are
/// asked for, so one thread reads at a time.
class Accessor {
  public:
    /// The lists of sparse indices of a document that were read. Many accessors may have one list.
    struct SparseLists {
        /// The last index of those that increase. By buffer view, first byte, component type and count.
        std::map<std::array<std::size_t, 4>, std::uint32_t> last;
        std::size_t indices = 0; ///< of all of them, which may overlap
    };

    /// @param root of the document.
    /// @param lists of this document; the accessor's own is added.
    Accessor(const nlohmann::json& root, const Buffers& buffers, int index, SparseLists& lists);

    /// The same, with elements that are elsewhere, of its type and count.
    Accessor(const Accessor& declared, Strided elements);

    std::size_t count() const { return m_count; }
    /// Of all elements together.
    std::size_t bytes() const { return m_count * m_elementBytes; }
    /// Components of an element: 1 for SCALAR to 4 for VEC4, 16 for MAT4, 0 for smaller matrices.
    int components() const { return m_components; }
    /// glTF's number.
    int componentType() const { return m_form.type; }
    /// Whether bytes in the file back its elements, sparse ones aside.
    bool hasData() const { return m_elements.isThere(); }
    /// From one element to the next in a file, 0 if they are in memory.
    std::size_t bytesApartInFile() const { return m_elements.bytesApartInFile(); }
    bool isSparse() const { return m_sparseCount > 0; }

    /// Element `i` < count() as floats, absent components as in (0, 0, 0, 1); of a matrix its first column.
    glm::vec4 vector(std::size_t i) const;
    /// Element `i` < count() of a MAT4, column by column.
    glm::dmat4 matrix(std::size_t i) const;
    /// Component 0 of element `i` < count() as an integer; the accessor must pass requireIndices().
    std::uint32_t integer(std::size_t i) const;
    /// Refuses an accessor that cannot hold vertex indices.
    void requireIndices(int index) const;

  private:
    void readSparse(const nlohmann::json& sparse, const Buffers& buffers, int index, SparseLists& lists);
    /// The last of the sparse indices; none where they do not increase.
    std::optional<std::uint32_t> lastIncreasing() const;
    const std::uint8_t* element(std::size_t i) const;
    std::uint32_t sparseIndex(std::size_t i) const;

    std::size_t m_count = 0;
    int m_components = 0;
    ComponentForm m_form;
    std::size_t m_elementBytes = 0;
    Strided m_elements;
    std::size_t m_sparseCount = 0;
    int m_sparseIndexType = 0;
    Strided m_sparseIndices; ///< increasing
    Strided m_sparseElements;
};

/// From one element to the next, all that is in files of the elements of these together; null ones have none.
std::size_t bytesApartInFile(std::initializer_list<const Accessor*> accessors);

/// A document's accessors, each checked once, when first used.
class Accessors {
  public:
    /// @param root of the document. Both must outlive this.
    Accessors(const nlohmann::json& root, const Buffers& buffers);

    const Accessor& at(int index);

  private:
    const nlohmann::json& m_root;
    const Buffers& m_buffers;
    std::map<int, Accessor> m_checked; ///< by index
    Accessor::SparseLists m_sparseLists;
};

} // namespace cdr::scene::gltf
