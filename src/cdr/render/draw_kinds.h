#pragma once

#include <cdr/render/draw_source.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace cdr::render {

class SceneMeshes;
class SceneTextures;

/// The kinds of a scene's draws, each once. There are only ever more of them, until clear().
class DrawKinds {
  public:
    /// Mesh, material, mirrored.
    using Key = std::tuple<std::uint32_t, std::uint32_t, bool>;
    /// What they are read from.
    struct From {
        const scene::Scene& scene;
        const SceneMeshes& meshes;
        const SceneTextures& textures;
        const std::vector<LayerPlace>& layers; ///< by material
    };

    const std::vector<DrawKind>& all() const { return m_kinds; }
    const Key& keyOf(std::size_t kind) const { return m_keys[kind]; }
    /// Makes it where it is not there yet.
    std::uint32_t indexOf(const Key& key, const From& from);
    /// Reads those of meshes again, in time by the number of these; nothing: all. Whether any says something else now.
    bool read(const std::optional<std::span<const std::uint32_t>>& meshes, const From& from);
    void clear();

  private:
    bool readOne(std::uint32_t kind, const From& from);
    bool readAll(const From& from);

    std::vector<DrawKind> m_kinds;
    std::vector<Key> m_keys;
    std::map<Key, std::uint32_t> m_indices;
};

} // namespace cdr::render
