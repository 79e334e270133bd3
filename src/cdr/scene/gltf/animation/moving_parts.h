#pragma once

#include "../accessor.h"
#include "../memory.h"
#include "../nodes/nodes.h"
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
    bool moves(const MeshNode& node) const { return m_animated[static_cast<std::size_t>(node.node)]; }
    /// Whether a primitive deforms where a node draws it: it needs a mesh of its own there.
    bool deforms(const MeshNode& node, const Primitive& primitive) const;
    /// What such a primitive takes: its deformer, and what poses it.
    PrimitiveBytes predict(const MeshNode& node, const Primitive& primitive) const;

    /// Notes that a node carries an instance. @param origin of its mesh, in the node's space
    void carry(const MeshNode& node, std::uint32_t instance, const glm::dvec3& origin);

    /// Adds the mesh of a node, which all copies of the node share. @return its index among those that deform.
    std::size_t addDeformed(Scene& scene, const MeshNode& node, const Primitive& primitive,
                            SourcePrimitive source, const std::string& where);
    /// Adds an instance of such a mesh. @param deformed its index. @param node as it is, or as one of its copies
    void place(Scene& scene, std::size_t deformed, const MeshNode& node, std::uint32_t material,
               std::uint32_t object);

    /// What was collected; null where nothing can move. Brings deformed meshes to their shape at rest.
    std::shared_ptr<const SceneAnimation> finish(Scene& scene);

    const std::vector<std::optional<std::size_t>>& rigNodes() const { return m_rig.nodeOf; }

  private:
    std::optional<std::size_t> skinOf(const MeshNode& node, const Primitive& primitive) const;

    Accessors& m_accessors;
    Notes& m_notes;
    std::vector<bool> m_animated; ///< by node of the file
    std::vector<bool> m_morphed;  ///< by node of the file, by an animation or at rest
    FileRig m_rig;
    std::map<int, std::size_t> m_skins; ///< by skin of the file, into SceneAnimation::skins
    std::shared_ptr<SceneAnimation> m_made = std::make_shared<SceneAnimation>();
};

} // namespace cdr::scene::gltf
