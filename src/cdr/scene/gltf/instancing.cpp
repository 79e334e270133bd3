#include "instancing.h"

#include "checks.h"
#include "json.h"

#include <cdr/scene/animation/pose.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

const Accessor* attribute(const json& attributes, const char* name, int components, Accessors& accessors,
                          const std::string& where) {
    const std::optional<int> index = indexMember(attributes, name);
    if (!index) {
        return nullptr;
    }
    const Accessor& accessor = accessors.at(*index);
    if (accessor.components() != components) {
        refuse("{}: {} of {} has {} components", where, name, kInstancing, accessor.components());
    }
    return &accessor;
}

} // namespace

MeshCopies::MeshCopies(const json& extension, Accessors& accessors, const std::string& where)
    : m_where(where) {
    const json& attributes = objectMember(extension, "attributes", where);
    m_translation = attribute(attributes, "TRANSLATION", 3, accessors, where);
    m_rotation = attribute(attributes, "ROTATION", 4, accessors, where);
    m_scale = attribute(attributes, "SCALE", 3, accessors, where);
    std::optional<std::size_t> count;
    for (const auto& [name, index] : indicesByName(attributes)) {
        const std::size_t here = accessors.at(index).count();
        if (count.value_or(here) != here) {
            refuse("{}: attributes of {} have {} and {} elements", where, kInstancing, *count, here);
        }
        count = here;
    }
    if (!count) {
        refuse("{}: {} has no attributes", where, kInstancing);
    }
    m_count = *count;
}

glm::dmat4 MeshCopies::toNode(std::size_t copy) const {
    LocalTransform local;
    if (m_translation != nullptr) {
        local.translation = glm::dvec3(m_translation->vector(copy));
    }
    if (m_rotation != nullptr) {
        const glm::dvec4 turn(m_rotation->vector(copy)); // glm takes w first
        local.rotation = glm::dquat(turn.w, turn.x, turn.y, turn.z);
        const double length = glm::length(local.rotation);
        if (!(length > 0.0) || !std::isfinite(length)) {
            refuse("{}: the rotation of its copy {} has no direction", m_where, copy);
        }
        local.rotation /= length;
    }
    if (m_scale != nullptr) {
        local.scale = glm::dvec3(m_scale->vector(copy));
    }
    const glm::dmat4 place = matrixOf(local);
    for (int column = 0; column < 4; ++column) {
        if (!std::isfinite(glm::dot(place[column], place[column]))) {
            refuse("{}: the place of its copy {} is not finite", m_where, copy);
        }
    }
    return place;
}

} // namespace cdr::scene::gltf
