#pragma once

#include "../accessor.h"
#include "../memory.h"
#include "../nodes.h"
#include "../notes.h"
#include "../primitive.h"
#include "deformers.h"
#include "rig.h"

#include <cdr/scene/animation/scene_animation.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// Collects what of a scene nodes move, while instances are made.
class MovingParts {
  public:
    /// Reads animations and the skins that nodes of the scene use.
    /// @param root of the document. All must outlive this.
    MovingParts(const nlohmann::json& root, const PlacedNodes& nodes, Accessors& accessors,
                MemoryPrediction& memory, Notes& notes);

    /// Whether an animation may move or deform what a node draws.
    bool moves(const MeshNode& node) const;
    /// Whether a primitive deforms where a node draws it: it needs a mesh of its own there.
    bool deforms(const MeshNode& node, const Primitive& primitive) const;

    /// Notes that a node carries an instance. @param origin of its mesh, in the node's space
    void carry(const MeshNode& node, std::uint32_t instance, const glm::dvec3& origin);

    /// Adds a mesh of its own, and an instance of it.
    void addDeformed(Scene& scene, const MeshNode& node, const Primitive& primitive, SourcePrimitive source,
                     std::uint32_t material, std::uint32_t object, const std::string& where);

    /// What was collected; null where nothing can move. Brings deformed meshes to their shape at rest.
    std::shared_ptr<const SceneAnimation> finish(Scene& scene);

    const std::vector<std::optional<std::size_t>>& rigNodes() const { return m_rig.nodeOf; }

  private:
    std::optional<std::size_t> skinOf(const MeshNode& node, const Primitive& primitive) const;

    const nlohmann::json& m_root;
    Accessors& m_accessors;
    Notes& m_notes;
    std::vector<bool> m_animated; ///< by node of the file
    std::vector<bool> m_morphed;  ///< by node of the file
    FileRig m_rig;
    std::map<int, std::size_t> m_skins; ///< by skin of the file, into SceneAnimation::skins
    std::shared_ptr<SceneAnimation> m_made = std::make_shared<SceneAnimation>();
};

} // namespace cdr::scene::gltf
