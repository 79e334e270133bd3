#pragma once

#include "accessor.h"

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace cdr::scene::gltf {

inline constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// The places of a node's mesh by EXT_mesh_gpu_instancing.
class MeshCopies {
  public:
    /// Refuses attributes that are not as the extension has them.
    /// @param extension of the node. @param accessors must outlive this.
    MeshCopies(const nlohmann::json& extension, Accessors& accessors, const std::string& where);

    std::size_t count() const { return m_count; }
    /// In the node's space. Refuses a place that is not finite, or a rotation without direction.
    glm::dmat4 toNode(std::size_t copy) const;

  private:
    std::string m_where;
    std::size_t m_count = 0;
    const Accessor* m_translation = nullptr;
    const Accessor* m_rotation = nullptr;
    const Accessor* m_scale = nullptr;
};

} // namespace cdr::scene::gltf
