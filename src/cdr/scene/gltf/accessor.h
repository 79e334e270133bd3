#pragma once

#include "bytes/files.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <map>

namespace cdr::scene::gltf {

/// Elements at even distances inside a buffer; `first` is null for elements that are zero.
struct Strided {
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;

    const std::uint8_t* at(std::size_t i) const { return first + i * stride; }
};

/// One accessor. Every byte that its elements can touch was checked to lie inside its buffer.
class Accessor {
  public:
    /// @param root of the document.
    Accessor(const nlohmann::json& root, const Buffers& buffers, int index);

    /// The same, with elements that are elsewhere, of its type and count.
    Accessor(const Accessor& declared, Strided elements);

    std::size_t count() const { return m_count; }
    /// Components of an element: 1 for SCALAR to 4 for VEC4, 16 for MAT4, 0 for smaller matrices.
    int components() const { return m_components; }
    /// glTF's number.
    int componentType() const { return m_componentType; }
    /// Whether bytes in the file back its elements, sparse ones aside.
    bool hasData() const { return m_elements.first != nullptr; }
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
    void readSparse(const nlohmann::json& sparse, const Buffers& buffers, int index);
    const std::uint8_t* element(std::size_t i) const;

    std::size_t m_count = 0;
    int m_components = 0;
    int m_componentType = 0;
    bool m_normalized = false;
    Strided m_elements;
    std::size_t m_sparseCount = 0;
    int m_sparseIndexType = 0;
    Strided m_sparseIndices; ///< increasing
    Strided m_sparseElements;
};

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
};

} // namespace cdr::scene::gltf
