#include "uv.h"

#include "../checks.h"
#include "../json.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kTransform = "KHR_texture_transform";

/// Two numbers of an extension's array member, or the fallback when it is absent.
glm::dvec2 pairOf(const json& extension, const char* key, const glm::dvec2& fallback) {
    const json* pair = member(extension, key);
    if (pair == nullptr) {
        return fallback;
    }
    if (!pair->is_array() || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number()) {
        refuse("{}: '{}' is not two numbers", kTransform, key);
    }
    return {(*pair)[0].get<double>(), (*pair)[1].get<double>()};
}

/// The transform of a source as a matrix.
glm::dmat3 matrixOf(const UvSource& uv) {
    const double c = std::cos(uv.rotation);
    const double s = std::sin(uv.rotation);
    return {glm::dvec3(c * uv.scale.x, -s * uv.scale.x, 0.0), glm::dvec3(s * uv.scale.y, c * uv.scale.y, 0.0),
            glm::dvec3(uv.offset, 1.0)};
}

int texCoordOf(const json& extension, int fallback) {
    const json* set = member(extension, "texCoord");
    if (set == nullptr) {
        return fallback;
    }
    if (!set->is_number_unsigned() || set->get<std::uint64_t>() > std::numeric_limits<std::int32_t>::max()) {
        refuse("{}: 'texCoord' is not an index", kTransform);
    }
    return set->get<int>();
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
        uv.texCoord = texCoordOf(*transform, uv.texCoord);
    }
    return uv;
}

} // namespace cdr::scene::gltf
