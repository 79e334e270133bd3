#include <cdr/render/shadows/divided_view.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::render {

namespace {

struct Rectangle {
    glm::dvec2 low;
    glm::dvec2 high;
};

/// Whether a line of this normal lies between the points and the rectangle.
bool separates(const glm::dvec2& normal, const SeenCorners& points, const Rectangle& rectangle) {
    const glm::dvec2 middle = 0.5 * (rectangle.low + rectangle.high);
    const double reach = glm::dot(glm::abs(normal), 0.5 * (rectangle.high - rectangle.low));
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const glm::dvec2& point : points) {
        least = std::min(least, glm::dot(normal, point - middle));
        most = std::max(most, glm::dot(normal, point - middle));
    }
    return least > reach || most < -reach;
}

/// Whether the hull of the points meets the rectangle. Edges of the hull are among the lines between two of them.
bool meets(const SeenCorners& points, const Rectangle& rectangle) {
    if (separates({1.0, 0.0}, points, rectangle) || separates({0.0, 1.0}, points, rectangle)) {
        return false;
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const glm::dvec2 edge = points[i] - points[j];
            if (separates({-edge.y, edge.x}, points, rectangle)) {
                return false;
            }
        }
    }
    return true;
}

/// Texels of one side of a part.
struct Side {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// Of the whole map's texels, when halved: what is read, without the border.
std::array<Side, 2> halvesOf(std::uint32_t texels) {
    const std::uint32_t border = 2 * kMapBorder;
    return {{{border, texels}, {texels, 2 * texels - border}}};
}

} // namespace

double pixelsPerTexel(const LightView& view, double footprintSlope) {
    return view.texel * (view.isDistant() ? 1.0 : view.farAhead) / (footprintSlope * view.nearView);
}

std::vector<LightView> dividedView(const LightView& view, const ReceiverSlice& slice,
                                   const glm::dvec3& camera, double footprintSlope) {
    const double pixels = pixelsPerTexel(view, footprintSlope);
    if (!(pixels > kWidestTexel && 0.5 * pixels <= kWidestTexel)) {
        return {view};
    }
    const glm::dvec3 shift = view.origin - camera;
    const std::array bodies{seenBy(view, slice.view, shift), seenBy(view, slice.boxes, shift)};
    std::vector<LightView> parts;
    for (const Side& down : halvesOf(view.size.height)) {
        for (const Side& across : halvesOf(view.size.width)) {
            LightView part = view;
            part.isPart = true;
            part.texel = 0.5 * view.texel;
            part.low = view.low + part.texel * (glm::dvec2(across.begin, down.begin) - double{kMapBorder});
            part.size = vk::Extent2D{across.end - across.begin + 2 * kMapBorder,
                                     down.end - down.begin + 2 * kMapBorder};
            const Rectangle shown{part.low,
                                  part.low + part.texel * glm::dvec2(part.size.width, part.size.height)};
            if (std::ranges::all_of(bodies, [&](const auto& body) { return !body || meets(*body, shown); })) {
                parts.push_back(part);
            }
        }
    }
    return parts;
}

} // namespace cdr::render
