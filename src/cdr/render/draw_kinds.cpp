#include <cdr/render/draw_kinds.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/render/upload/scene_meshes.h>

#include <utility>

namespace cdr::render {

namespace {

DrawKind kindOf(const DrawKinds::Key& key, const DrawKinds::From& from) {
    const auto [mesh, materialIndex, mirrored] = key;
    const scene::Material& material = from.scene.materials[materialIndex];
    const MeshRange& range = from.meshes.ranges()[mesh];
    return {.meshIndex = mesh,
            .mesh = range,
            .variant =
                variantOf(range.isFaceted, material, from.textures.detailParts(from.scene, materialIndex)),
            .doubleSided = material.doubleSided,
            .mirrored = mirrored,
            .layer = from.layers[materialIndex],
            .textureSet = from.textures.baseColorSet(from.scene, materialIndex),
            .detailSet = from.textures.detailSet(materialIndex)};
}

template <typename T>
void makeRoomForOne(std::vector<T>& all) {
    if (all.size() == all.capacity()) {
        all.reserve(2 * all.size() + 1);
    }
}

} // namespace

std::uint32_t DrawKinds::indexOf(const Key& key, const From& from) {
    if (const auto found = m_indices.find(key); found != m_indices.end()) {
        return found->second;
    }
    // All that may find no memory comes first.
    const DrawKind made = kindOf(key, from);
    makeRoomForOne(m_keys);
    makeRoomForOne(m_kinds);
    const auto index = static_cast<std::uint32_t>(m_kinds.size());
    m_indices.emplace(key, index);
    m_keys.push_back(key);
    m_kinds.push_back(made);
    return index;
}

bool DrawKinds::readOne(std::uint32_t kind, const From& from) {
    const DrawKind before = std::exchange(m_kinds[kind], kindOf(m_keys[kind], from));
    return before != m_kinds[kind];
}

bool DrawKinds::readAll(const From& from) {
    bool isAnyOther = false;
    for (std::uint32_t kind = 0; kind < m_kinds.size(); ++kind) {
        isAnyOther = readOne(kind, from) || isAnyOther;
    }
    return isAnyOther;
}

bool DrawKinds::read(const std::optional<std::span<const std::uint32_t>>& meshes, const From& from) {
    if (!meshes) {
        return readAll(from);
    }
    bool isAnyOther = false;
    for (const std::uint32_t mesh : *meshes) {
        for (auto entry = m_indices.lower_bound(Key{mesh, 0, false});
             entry != m_indices.end() && std::get<0>(entry->first) == mesh; ++entry) {
            isAnyOther = readOne(entry->second, from) || isAnyOther;
        }
    }
    return isAnyOther;
}

void DrawKinds::clear() {
    m_kinds.clear();
    m_keys.clear();
    m_indices.clear();
}

} // namespace cdr::render
