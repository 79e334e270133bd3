#include "accessor.h"

#include "checks.h"
#include "component.h"

#include <algorithm>

namespace cdr::scene::gltf {

namespace {

/// Refuses elements of which any byte lies outside the view. No sum here can overflow: all numbers are below
/// 2^31.
Strided locate(std::span<const std::uint8_t> view, std::size_t offset, std::size_t stride,
               std::size_t elementBytes, std::size_t count, int accessor) {
    const std::size_t needed = count == 0 ? 0 : offset + stride * (count - 1) + elementBytes;
    if (stride < elementBytes || needed > view.size()) {
        refuse(
            "accessor {}: {} elements of {} bytes, {} apart, from byte {} do not fit its buffer view of {}",
            accessor, count, elementBytes, stride, offset, view.size());
    }
    return {view.data() + std::min(offset, view.size()), stride};
}

} // namespace

Accessor::Accessor(const tinygltf::Model& model, const Buffers& buffers, int index) {
    const tinygltf::Accessor& accessor = itemAt(model.accessors, index, "accessor");
    m_components = componentsOf(accessor.type);
    m_componentType = accessor.componentType;
    m_normalized = accessor.normalized;
    m_count = accessor.count;
    const std::size_t elementBytes = static_cast<std::size_t>(m_components) * componentBytes(m_componentType);
    if (accessor.bufferView >= 0) {
        const std::size_t viewStride =
            itemAt(model.bufferViews, accessor.bufferView, "buffer view").byteStride;
        m_elements = locate(buffers.view(model, accessor.bufferView), accessor.byteOffset,
                            viewStride == 0 ? elementBytes : viewStride, elementBytes, m_count, index);
    }
    if (accessor.sparse.isSparse) {
        readSparse(model, buffers, accessor, index);
    }
}

void Accessor::readSparse(const tinygltf::Model& model, const Buffers& buffers,
                          const tinygltf::Accessor& accessor, int index) {
    const auto& sparse = accessor.sparse;
    m_sparseIndexType = sparse.indices.componentType;
    m_sparseCount = static_cast<std::size_t>(sparse.count);
    if (!isIndexType(m_sparseIndexType) || m_sparseCount < 1 || m_sparseCount > m_count) {
        refuse("accessor {}: its sparse part has {} elements of {}, indexed by component type {}", index,
               sparse.count, m_count, m_sparseIndexType);
    }
    const std::size_t indexBytes = componentBytes(m_sparseIndexType);
    const std::size_t elementBytes = static_cast<std::size_t>(m_components) * componentBytes(m_componentType);
    m_sparseIndices = locate(buffers.view(model, sparse.indices.bufferView),
                             static_cast<std::size_t>(sparse.indices.byteOffset), indexBytes, indexBytes,
                             m_sparseCount, index);
    m_sparseElements = locate(buffers.view(model, sparse.values.bufferView),
                              static_cast<std::size_t>(sparse.values.byteOffset), elementBytes, elementBytes,
                              m_sparseCount, index);
    for (std::size_t i = 0; i < m_sparseCount; ++i) {
        const std::uint32_t current = unsignedAt(m_sparseIndices.at(i), m_sparseIndexType);
        if (current >= m_count ||
            (i > 0 && current <= unsignedAt(m_sparseIndices.at(i - 1), m_sparseIndexType))) {
            refuse("accessor {}: its sparse indices do not increase or exceed its {} elements", index,
                   m_count);
        }
    }
}

const std::uint8_t* Accessor::element(std::size_t i) const {
    std::size_t low = 0;
    std::size_t high = m_sparseCount;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        const std::size_t found = unsignedAt(m_sparseIndices.at(middle), m_sparseIndexType);
        if (found == i) {
            return m_sparseElements.at(middle);
        }
        (found < i ? low : high) = found < i ? middle + 1 : middle;
    }
    return hasData() ? m_elements.at(i) : nullptr;
}

glm::vec4 Accessor::vector(std::size_t i) const {
    glm::vec4 result(0.0f, 0.0f, 0.0f, 1.0f);
    const std::uint8_t* bytes = element(i);
    const std::size_t size = componentBytes(m_componentType);
    for (int c = 0; c < m_components; ++c) {
        result[c] = bytes == nullptr
                        ? 0.0f
                        : static_cast<float>(component(bytes + static_cast<std::size_t>(c) * size,
                                                       m_componentType, m_normalized));
    }
    return result;
}

std::uint32_t Accessor::integer(std::size_t i) const {
    const std::uint8_t* bytes = element(i);
    return bytes == nullptr ? 0 : unsignedAt(bytes, m_componentType);
}

void Accessor::requireIndices(int index) const {
    if (m_components != 1 || !isIndexType(m_componentType) || m_normalized) {
        refuse("accessor {} cannot hold vertex indices: it is not a SCALAR of unsigned integers", index);
    }
}

Accessors::Accessors(const tinygltf::Model& model, const Buffers& buffers)
    : m_model(model),
      m_buffers(buffers),
      m_checked(model.accessors.size()) {}

const Accessor& Accessors::at(int index) {
    itemAt(m_model.accessors, index, "accessor");
    std::optional<Accessor>& checked = m_checked[static_cast<std::size_t>(index)];
    if (!checked) {
        checked.emplace(m_model, m_buffers, index);
    }
    return *checked;
}

} // namespace cdr::scene::gltf
