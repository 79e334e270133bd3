#include "accessor.h"

#include "checks.h"
#include "component.h"
#include "json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Of all lists that are read; a file may have many that overlap.
constexpr std::size_t kMaxSparseIndices = std::size_t{1} << 27;

std::size_t byteOffset(const json& part) {
    return static_cast<std::size_t>(indexMember(part, "byteOffset").value_or(0));
}

/// Refuses elements of which any byte lies outside the view. No sum here can overflow: all numbers are below
/// 2^31.
Strided locate(const Buffers& buffers, const BufferView& view, std::size_t offset, std::size_t stride,
               std::size_t elementBytes, std::size_t count, int accessor) {
    const std::size_t needed = count == 0 ? 0 : offset + stride * (count - 1) + elementBytes;
    if (stride < elementBytes || needed > view.bytes.size()) {
        refuse(
            "accessor {}: {} elements of {} bytes, {} apart, from byte {} do not fit its buffer view of {}",
            accessor, count, elementBytes, stride, offset, view.bytes.size());
    }
    const std::size_t first = std::min(offset, view.bytes.size());
    return {view.bytes.part(first, view.bytes.size() - first), stride, buffers.blocks()};
}

} // namespace

Accessor::Accessor(const json& root, const Buffers& buffers, int index, SparseLists& lists) {
    const json& accessor = itemAt(root, "accessors", index, "accessor");
    const std::string where = fmt::format("accessor {}", index);
    m_components = componentsOf(stringMember(accessor, "type").value_or(""), where);
    m_form.type = requiredIndex(accessor, "componentType", where);
    m_form.normalized = boolMember(accessor, "normalized", where);
    m_count = static_cast<std::size_t>(requiredIndex(accessor, "count", where));
    m_elementBytes = static_cast<std::size_t>(m_components) * componentBytes(m_form.type);
    if (const std::optional<int> bufferView = indexMember(accessor, "bufferView")) {
        const BufferView view = buffers.view(*bufferView);
        m_elements = locate(buffers, view, byteOffset(accessor),
                            view.stride == 0 ? m_elementBytes : view.stride, m_elementBytes, m_count, index);
    }
    if (member(accessor, "sparse") != nullptr) {
        readSparse(objectMember(accessor, "sparse", where), buffers, index, lists);
    }
}

Accessor::Accessor(const Accessor& declared, Strided elements) : Accessor(declared) {
    m_elements = elements;
}

void Accessor::readSparse(const json& sparse, const Buffers& buffers, int index, SparseLists& lists) {
    const std::string where = fmt::format("accessor {}: its sparse part", index);
    const json& indices = objectMember(sparse, "indices", where);
    const json& values = objectMember(sparse, "values", where);
    m_sparseIndexType = requiredIndex(indices, "componentType", where);
    m_sparseCount = static_cast<std::size_t>(requiredIndex(sparse, "count", where));
    if (!isIndexType(m_sparseIndexType) || m_sparseCount < 1 || m_sparseCount > m_count) {
        refuse("{} has {} elements of {}, indexed by component type {}", where, m_sparseCount, m_count,
               m_sparseIndexType);
    }
    const auto packed = [&](const json& part, std::size_t elementBytes) {
        return locate(buffers, buffers.view(requiredIndex(part, "bufferView", where)), byteOffset(part),
                      elementBytes, elementBytes, m_sparseCount, index);
    };
    m_sparseIndices = packed(indices, componentBytes(m_sparseIndexType));
    m_sparseElements = packed(values, m_elementBytes);
    const std::array list{static_cast<std::size_t>(requiredIndex(indices, "bufferView", where)),
                          byteOffset(indices), static_cast<std::size_t>(m_sparseIndexType), m_sparseCount};
    const auto known = lists.last.find(list);
    lists.indices += known != lists.last.end() ? 0 : m_sparseCount;
    if (lists.indices > kMaxSparseIndices) {
        refuse("accessor {}: its sparse indices and those of accessors before it are over the limit of {}",
               index, kMaxSparseIndices);
    }
    const std::optional<std::uint32_t> last = known != lists.last.end() ? known->second : lastIncreasing();
    if (!last || *last >= m_count) {
        refuse("accessor {}: its sparse indices do not increase or exceed its {} elements", index, m_count);
    }
    lists.last.emplace(list, *last);
}

std::optional<std::uint32_t> Accessor::lastIncreasing() const {
    std::uint32_t last = sparseIndex(0);
    for (std::size_t i = 1; i < m_sparseCount; ++i) {
        const std::uint32_t current = sparseIndex(i);
        if (current <= last) {
            return std::nullopt;
        }
        last = current;
    }
    return last;
}

std::uint32_t Accessor::sparseIndex(std::size_t i) const {
    return unsignedAt(m_sparseIndices.at(i, componentBytes(m_sparseIndexType)), m_sparseIndexType);
}

const std::uint8_t* Accessor::element(std::size_t i) const {
    std::size_t low = 0;
    std::size_t high = m_sparseCount;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        const std::size_t found = sparseIndex(middle);
        if (found == i) {
            return m_sparseElements.at(middle, m_elementBytes);
        }
        (found < i ? low : high) = found < i ? middle + 1 : middle;
    }
    return hasData() ? m_elements.at(i, m_elementBytes) : nullptr;
}

glm::vec4 Accessor::vector(std::size_t i) const {
    glm::vec4 result(0.0f, 0.0f, 0.0f, 1.0f);
    const std::uint8_t* bytes = element(i);
    const std::size_t size = componentBytes(m_form.type);
    for (int c = 0; c < std::min(m_components, 4); ++c) {
        result[c] = bytes == nullptr
                        ? 0.0f
                        : static_cast<float>(component(bytes + static_cast<std::size_t>(c) * size, m_form));
    }
    return result;
}

glm::dmat4 Accessor::matrix(std::size_t i) const {
    glm::dmat4 result(0.0);
    const std::uint8_t* bytes = element(i);
    const std::size_t size = componentBytes(m_form.type);
    for (int c = 0; bytes != nullptr && c < std::min(m_components, 16); ++c) {
        result[c / 4][c % 4] = component(bytes + static_cast<std::size_t>(c) * size, m_form);
    }
    return result;
}

std::uint32_t Accessor::integer(std::size_t i) const {
    const std::uint8_t* bytes = element(i);
    return bytes == nullptr ? 0 : unsignedAt(bytes, m_form.type);
}

void Accessor::requireIndices(int index) const {
    if (m_components != 1 || !isIndexType(m_form.type) || m_form.normalized) {
        refuse("accessor {} cannot hold vertex indices: it is not a SCALAR of unsigned integers", index);
    }
}

std::size_t bytesApartInFile(std::initializer_list<const Accessor*> accessors) {
    std::size_t bytes = 0;
    for (const Accessor* accessor : accessors) {
        bytes += accessor == nullptr ? 0 : accessor->bytesApartInFile();
    }
    return bytes;
}

Accessors::Accessors(const json& root, const Buffers& buffers) : m_root(root), m_buffers(buffers) {}

const Accessor& Accessors::at(int index) {
    const auto found = m_checked.find(index);
    return found != m_checked.end()
               ? found->second
               : m_checked.emplace(index, Accessor(m_root, m_buffers, index, m_sparseLists)).first->second;
}

} // namespace cdr::scene::gltf
