#include "uv.h"

#include "../json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kTransform = "KHR_texture_transform";

/// Two numbers of an extension's array member, or the fallback when it is absent.
glm::dvec2 pairOf(const json& extension, const char* key, const glm::dvec2& fallback) {
    const auto pair = numbersMember(extension, key, 2, kTransform);
    return pair ? glm::dvec2((*pair)[0], (*pair)[1]) : fallback;
}

/// The transform of a source as a matrix.
glm::dmat3 matrixOf(const UvSource& uv) {
    const double c = std::cos(uv.rotation);
    const double s = std::sin(uv.rotation);
    return {glm::dvec3(c * uv.scale.x, -s * uv.scale.x, 0.0), glm::dvec3(s * uv.scale.y, c * uv.scale.y, 0.0),
            glm::dvec3(uv.offset, 1.0)};
}

} // namespace

glm::vec2 UvSource::apply(const glm::vec4& uv) const {
    // The extension's GLSL listing turns the other way than its example, its text and every implementation.
    const double c = std::cos(rotation);
    const double s = std::sin(rotation);
    const glm::dvec2 scaled = glm::dvec2(uv.x, uv.y) * scale;
    const glm::vec2 result(offset + glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x));
    return std::isfinite(result.x) && std::isfinite(result.y) ? result : glm::vec2(0.0f);
}

std::optional<glm::mat3x2> UvSource::leadingTo(const UvSource& other) const {
    const glm::mat3x2 way(matrixOf(other) * glm::inverse(matrixOf(*this)));
    for (int column = 0; column < 3; ++column) {
        if (!std::isfinite(way[column].x) || !std::isfinite(way[column].y)) {
            return {};
        }
    }
    return way;
}

UvSource uvSourceOf(const json& info) {
    UvSource uv;
    uv.texCoord = indexMember(info, "texCoord").value_or(0);
    if (const json* transform = extensionOf(info, kTransform)) {
        uv.offset = pairOf(*transform, "offset", uv.offset);
        uv.scale = pairOf(*transform, "scale", uv.scale);
        uv.rotation = numberMember(*transform, "rotation", kTransform).value_or(uv.rotation);
        uv.texCoord = indexMember(*transform, "texCoord").value_or(uv.texCoord);
    }
    return uv;
}

} // namespace cdr::scene::gltf
