#include "uv.h"

#include "checks.h"

#include <tiny_gltf.h>

#include <cmath>

namespace cdr::scene::gltf {

namespace {

/// Two numbers of an extension's array member, or the fallback when it is absent.
glm::dvec2 pairOf(const tinygltf::Value& extension, const std::string& key, const glm::dvec2& fallback) {
    if (!extension.Has(key)) {
        return fallback;
    }
    const tinygltf::Value& pair = extension.Get(key);
    if (!pair.IsArray() || pair.ArrayLen() != 2 || !pair.Get(0).IsNumber() || !pair.Get(1).IsNumber()) {
        refuse("KHR_texture_transform: '{}' is not two numbers", key);
    }
    return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
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

UvSource uvSourceOf(const tinygltf::TextureInfo& info) {
    UvSource uv;
    uv.texCoord = info.texCoord;
    const auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end()) {
        return uv;
    }
    const tinygltf::Value& transform = found->second;
    uv.offset = pairOf(transform, "offset", uv.offset);
    uv.scale = pairOf(transform, "scale", uv.scale);
    if (transform.Has("rotation")) {
        if (!transform.Get("rotation").IsNumber()) {
            refuse("KHR_texture_transform: 'rotation' is not a number");
        }
        uv.rotation = transform.Get("rotation").GetNumberAsDouble();
    }
    if (transform.Has("texCoord")) {
        if (!transform.Get("texCoord").IsInt() || transform.Get("texCoord").Get<int>() < 0) {
            refuse("KHR_texture_transform: 'texCoord' is not an index");
        }
        uv.texCoord = transform.Get("texCoord").Get<int>();
    }
    return uv;
}

} // namespace cdr::scene::gltf
