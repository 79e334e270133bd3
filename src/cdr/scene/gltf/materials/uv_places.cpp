#include "uv_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cdr::scene::gltf {

namespace {

/// Whether u and v still grow in the same directions, up to rounding.
bool keepsDirections(const glm::mat3x2& way) {
    constexpr float kSlack = 1e-6f;
    return way[0].x > 0.0f && way[1].y > 0.0f && std::abs(way[0].y) <= kSlack * way[0].x &&
           std::abs(way[1].x) <= kSlack * way[1].y;
}

} // namespace

UvPlaces choosePlaces(std::span<const UvSource> sources, const UvSource* normal) {
    std::vector<UvSource> unlike;
    for (const UvSource& source : sources) {
        if (std::find(unlike.begin(), unlike.end(), source) == unlike.end()) {
            unlike.push_back(source);
        }
    }
    UvPlaces places;
    if (!unlike.empty()) {
        places.first = unlike[0];
    }
    if (unlike.size() > 1) {
        places.second = unlike[1];
    }
    if (unlike.size() > 2) {
        const auto otherSet = std::ranges::find_if(
            unlike, [&](const UvSource& source) { return source.texCoord != unlike[0].texCoord; });
        if (otherSet != unlike.end()) {
            places.second = *otherSet;
        } else if (normal != nullptr && *normal != unlike[0]) {
            places.second = *normal;
        }
    }
    return places;
}

std::optional<TextureUse> useAt(const UvPlaces& places, const UvSource& source, Kept kept) {
    if (places.first == source || places.second == source) {
        return TextureUse{.second = places.first != source};
    }
    for (const bool second : {false, true}) {
        const std::optional<UvSource>& place = second ? places.second : places.first;
        const auto way =
            place && place->texCoord == source.texCoord ? place->leadingTo(source) : std::nullopt;
        if (way && (kept == Kept::nothing || keepsDirections(*way))) {
            return TextureUse{.second = second, .transform = *way};
        }
    }
    return {};
}

} // namespace cdr::scene::gltf
