#include <cdr/render/shadows/divided_view.h>
#include <cdr/render/shadows/light_shape.h>
#include <cdr/render/shadows/light_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace cdr::render {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A light is distant if it is so many times farther from a slice's middle than the slice reaches.
constexpr double kDistantRatio = 2.0;
/// What a texel need not be smaller than, of a pixel: surfaces that lie along the light need many for a pixel.
constexpr double kPixelsPerTexel = 0.125;
constexpr double kBorder = kMapBorder;

/// What a convex body covers of a view.
struct Cover {
    glm::dvec2 low{kInfinity};
    glm::dvec2 high{-kInfinity};
    double farAhead = -kInfinity;

    void cut(const Cover& other) {
        low = glm::max(low, other.low);
        high = glm::min(high, other.high);
        farAhead = std::min(farAhead, other.farAhead);
    }
    bool isEmpty() const { return !(low.x < high.x && low.y < high.y); }
};

using Corners = std::array<glm::dvec3, 8>;

/// @param shift from what corners are relative to, to the view's origin.
Cover coverOf(const LightView& view, const Corners& corners, const glm::dvec3& shift) {
    Cover cover;
    bool isBehind = false;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 place = view.toLight(corner - shift);
        const double w = view.w(place.z);
        cover.farAhead = std::max(cover.farAhead, place.z);
        isBehind = isBehind || w <= 0.0;
        cover.low = glm::min(cover.low, glm::dvec2(place) / w);
        cover.high = glm::max(cover.high, glm::dvec2(place) / w);
    }
    if (isBehind) { // it may cover anything
        cover.low = glm::dvec2(-kInfinity);
        cover.high = glm::dvec2(kInfinity);
    }
    return cover;
}

/// Whether a body lies wholly in front of a light, and not so near that its place in the view grows without bound.
bool isInFront(const LightView& view, const Corners& corners, const glm::dvec3& shift) {
    constexpr double kNearestW = 1.0 / 16.0; // 1 in the middle of the slice
    return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
        return view.w(view.toLight(corner - shift).z) >= kNearestW;
    });
}

/// Whether a body lies wholly beside one of the four planes of a side of the light.
bool isBeside(const LightView& side, const Corners& corners, const glm::dvec3& shift) {
    std::array<bool, 4> beside{true, true, true, true};
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 place = side.toLight(corner - shift);
        beside[0] = beside[0] && place.x > place.z;
        beside[1] = beside[1] && -place.x > place.z;
        beside[2] = beside[2] && place.y > place.z;
        beside[3] = beside[3] && -place.y > place.z;
    }
    return std::any_of(beside.begin(), beside.end(), [](bool all) { return all; });
}

/// An axis across a direction, the same for directions that are nearly the same.
glm::dvec3 across(const glm::dvec3& direction) {
    const glm::dvec3 axis =
        std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    return glm::normalize(glm::cross(axis, direction));
}

double powerOfTwoFrom(double value) {
    return std::exp2(std::ceil(std::log2(value)));
}

struct TexelLimits {
    double finest = 0.0;    ///< scene units that no texel need be smaller than
    std::uint32_t most = 0; ///< of a side of a map
};

/// The least of ..., 1, 1.5, 2, 3, 4, ... that suffices. So a map uses two thirds of its side, and floats hold texels exactly.
/// Where they are so wide that dividedView() halves them, it is a power of two.
double texelFrom(double least, const TexelLimits& limits) {
    const double power = powerOfTwoFrom(least);
    const double pixels = kPixelsPerTexel * power / limits.finest;
    return pixels <= kWidestTexel && 0.75 * power >= least ? 0.75 * power : power;
}

/// Lays texels over what is to be seen. They keep their places in the world, so shadows do not crawl as a camera moves.
void layTexels(LightView& view, const Cover& cover, const TexelLimits& limits) {
    const glm::dvec2 extent = cover.high - cover.low;
    const double widest = std::max(extent.x, extent.y);
    view.texel = std::max(texelFrom(widest / (limits.most - 2.0 * kBorder - 1.0), limits),
                          powerOfTwoFrom(limits.finest));
    const glm::dvec2 world =
        view.isDistant() ? glm::dvec2(glm::dot(view.right, view.origin), glm::dot(view.up, view.origin))
                         : glm::dvec2(0.0);
    view.low = (glm::floor((cover.low + world) / view.texel) - kBorder) * view.texel - world;
    const glm::dvec2 texels = glm::ceil((cover.high - view.low) / view.texel) + kBorder;
    const auto side = [&](double count) {
        return static_cast<std::uint32_t>(std::clamp(count, 1.0, static_cast<double>(limits.most)));
    };
    view.size = vk::Extent2D{side(texels.x), side(texels.y)};
}

/// The view with its map, unless it would show nothing.
std::optional<LightView> withMap(LightView view, const ReceiverSlice& slice, const glm::dvec3& shift,
                                 TexelLimits limits) {
    Cover cover = coverOf(view, slice.view, shift);
    cover.cut(coverOf(view, slice.boxes, shift));
    if (!view.isDistant()) {
        cover.cut({glm::dvec2(-1.0), glm::dvec2(1.0), kInfinity});
    }
    if (cover.isEmpty() || view.w(cover.farAhead) <= 0.0) {
        return std::nullopt;
    }
    view.farAhead = cover.farAhead;
    limits.finest /= view.isDistant() ? 1.0 : cover.farAhead;
    layTexels(view, cover, limits);
    return view;
}

} // namespace

shaders::LightLens LightView::lens() const {
    shaders::LightLens lens{.wOffset = static_cast<float>(wOffset),
                            .wPerUnit = static_cast<float>(wPerUnit),
                            .zOffset = 0.0f,
                            .zPerUnit = 0.0f,
                            .texel = static_cast<float>(texel)};
    if (isDistant()) { // 0 at the farthest receiver, where floats are densest, to 1 at the nearest caster
        const double scale = w(nearAhead) / (farAhead - nearAhead);
        lens.zOffset = static_cast<float>(farAhead * scale);
        lens.zPerUnit = static_cast<float>(-scale);
    } else {
        lens.zOffset = static_cast<float>(nearAhead);
    }
    return lens;
}

std::optional<SeenCorners> seenBy(const LightView& view, const std::array<glm::dvec3, 8>& corners,
                                  const glm::dvec3& shift) {
    SeenCorners points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 place = view.toLight(corners[i] - shift);
        const double w = view.w(place.z);
        if (w <= 0.0) {
            return std::nullopt;
        }
        points[i] = glm::dvec2(place) / w;
    }
    return points;
}

std::vector<LightView> lightViews(const scene::PointLight& light, const glm::dvec3& camera,
                                  const ReceiverSlice& slice, double footprintSlope,
                                  std::uint32_t maxTexels) {
    LightView view;
    view.nearView = slice.nearView;
    view.farView = slice.farView;
    const TexelLimits limits{.finest = kPixelsPerTexel * footprintSlope * slice.nearView, .most = maxTexels};
    std::vector<LightView> views;
    if (!isInRange(light, camera, slice)) {
        return views;
    }
    const glm::dvec3 way = (camera - light.position) + slice.middle;
    const double distance = std::hypot(way.x, way.y, way.z); // its square may overflow
    const auto add = [&](const glm::dvec3& shift) {
        const std::optional<LightView> made = withMap(view, slice, shift, limits);
        if (made && isInCone(light, *made)) {
            views.push_back(*made);
        }
    };
    if (distance > kDistantRatio * slice.reach) {
        view.origin = camera + slice.middle;
        view.ahead = way / distance;
        view.right = across(view.ahead);
        view.up = glm::cross(view.ahead, view.right);
        view.wPerUnit = 1.0 / distance;
        // Both bodies may reach behind the light, though what is in both does not. Then neither bounds a map.
        if (isInFront(view, slice.view, slice.middle) || isInFront(view, slice.boxes, slice.middle)) {
            add(slice.middle);
            return views;
        }
    }
    view.origin = light.position;
    view.wOffset = 0.0;
    view.wPerUnit = 1.0;
    for (int side = 0; side < 6; ++side) {
        view.ahead = glm::dvec3(0.0);
        view.ahead[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
        view.right = across(view.ahead);
        view.up = glm::cross(view.ahead, view.right);
        const glm::dvec3 shift = light.position - camera;
        if (!isBeside(view, slice.view, shift) && !isBeside(view, slice.boxes, shift)) {
            add(shift);
        }
    }
    return views;
}

} // namespace cdr::render
