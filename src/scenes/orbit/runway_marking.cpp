#include <cdr/base/error.h>
#include <scenes/orbit/runway_marking.h>

#include <vector>

namespace cdr::scenes {

namespace {

// A character stands in a box of width kWidth and height 1, its strokes' middles kInset inside.
constexpr double kStroke = 0.14;
constexpr double kInset = 0.5 * kStroke;
constexpr double kWidth = 0.56;
constexpr double kSpacing = 0.2;
constexpr double kLeft = kInset;
constexpr double kRight = kWidth - kInset;
constexpr double kTop = 1.0 - kInset;
constexpr double kBottom = kInset;
constexpr double kBend = 0.14; ///< of a corner cut at 45 degrees

struct Stroke {
    std::vector<glm::dvec2> points;
    MarkingPaint::Ends ends = MarkingPaint::Ends::open;
};

/// A ring with its corners cut, between two heights.
Stroke ring(double bottom, double top) {
    return {{{kLeft, bottom + kBend},
             {kLeft + kBend, bottom},
             {kRight - kBend, bottom},
             {kRight, bottom + kBend},
             {kRight, top - kBend},
             {kRight - kBend, top},
             {kLeft + kBend, top},
             {kLeft, top - kBend}},
            MarkingPaint::Ends::joined};
}

std::vector<Stroke> strokesOf(char character) {
    switch (character) {
    case '0':
        return {ring(kBottom, kTop)};
    case '2':
        return {{{{kLeft, kTop - kBend},
                  {kLeft + kBend, kTop},
                  {kRight - kBend, kTop},
                  {kRight, kTop - kBend},
                  {kRight, 0.62},
                  {kLeft, kBottom + 0.12},
                  {kLeft, kBottom},
                  {kRight, kBottom}}}};
    case '7':
        return {{{{kLeft, kTop}, {kRight, kTop}, {kRight, kTop - 0.16}, {kLeft + 0.1, 0.0}}}};
    case '9':
        return {ring(0.44, kTop),
                {{{kRight, 0.6}, {kRight, kBottom + kBend}, {kRight - kBend, kBottom}, {kLeft, kBottom}}}};
    case 'L':
        return {{{{kLeft, 1.0}, {kLeft, kBottom}, {kWidth, kBottom}}}};
    case 'R':
        return {{{{kLeft, 0.0},
                  {kLeft, kTop},
                  {kRight - kBend, kTop},
                  {kRight, kTop - kBend},
                  {kRight, 0.46 + kBend},
                  {kRight - kBend, 0.46},
                  {kLeft, 0.46}}},
                {{{0.5 * kWidth, 0.46}, {kRight, 0.0}}}};
    default:
        throw base::InputError(std::string("runway markings know no '") + character + "'");
    }
}

glm::dvec2 leftOf(const glm::dvec2& direction) {
    return {-direction.y, direction.x};
}

/// From a bend of a stroke to the left end of its mitre, for a half width of 1.
glm::dvec2 mitre(const glm::dvec2& before, const glm::dvec2& after) {
    const glm::dvec2 sum = leftOf(before) + leftOf(after);
    return sum * (2.0 / glm::dot(sum, sum));
}

} // namespace

void MarkingPaint::quad(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const auto first = static_cast<std::uint32_t>(m_mesh.positions.size());
    for (const glm::dvec2& corner : {a, b, c, d}) {
        m_mesh.positions.emplace_back(corner.y, 0.0, corner.x);
        m_mesh.vertices.push_back({.normal = glm::vec3(0.0f, 1.0f, 0.0f)});
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
        m_mesh.indices.push_back(first + corner);
    }
}

void MarkingPaint::stroke(std::span<const glm::dvec2> points, double width, Ends joins) {
    const bool closed = joins == Ends::joined;
    const std::size_t count = points.size();
    const auto direction = [&](std::size_t from) {
        return glm::normalize(points[(from + 1) % count] - points[from]);
    };
    std::vector<glm::dvec2> aside;
    for (std::size_t i = 0; i < count; ++i) {
        const bool begins = !closed && i == 0;
        const bool ends = !closed && i + 1 == count;
        const glm::dvec2 after = ends ? direction(i - 1) : direction(i);
        const glm::dvec2 before = begins ? after : direction((i + count - 1) % count);
        aside.push_back(0.5 * width * mitre(before, after));
    }
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const std::size_t j = (i + 1) % count;
        quad(points[i] - aside[i], points[j] - aside[j], points[j] + aside[j], points[i] + aside[i]);
    }
}

void MarkingPaint::rectangle(const glm::dvec2& low, const glm::dvec2& high) {
    quad(low, {high.x, low.y}, high, {low.x, high.y});
}

void MarkingPaint::text(std::string_view characters, double height) {
    const auto count = static_cast<double>(characters.size());
    double left = -0.5 * height * (count * kWidth + (count - 1.0) * kSpacing);
    for (const char character : characters) {
        for (Stroke& part : std::vector<Stroke>(strokesOf(character))) {
            for (glm::dvec2& point : part.points) {
                point = glm::dvec2(left, -0.5 * height) + height * point;
            }
            stroke(part.points, kStroke * height, part.ends);
        }
        left += height * (kWidth + kSpacing);
    }
}

} // namespace cdr::scenes
