#include <cdr/image/srgb.h>
#include <scenes/earth/blue_marble.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::scenes {

namespace {

/// Weights of four neighbours (cubic B-spline), between the second and the third of which `t` lies.
std::array<double, 4> splineWeights(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0};
}

/// The picture's sea is bluer than any land, and never bright.
double waterOf(const glm::dvec3& color) {
    const double blue = (color.b - std::max(color.r, color.g)) / std::max(color.r + color.g + color.b, 1e-6);
    return std::clamp(4.0 * blue + 0.5, 0.0, 1.0);
}

} // namespace

glm::dvec3 BlueMarble::texel(std::int64_t x, std::int64_t y) const {
    const auto width = static_cast<std::int64_t>(m_picture.width);
    const auto height = static_cast<std::int64_t>(m_picture.height);
    const image::Rgba8& pixel =
        m_picture.at(static_cast<std::uint32_t>((x % width + width) % width),
                     static_cast<std::uint32_t>(std::clamp(y, std::int64_t{0}, height - 1)));
    const std::array<double, 256>& linear = image::linearOfSrgb();
    return {linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]};
}

MarbleColor BlueMarble::at(const Geodetic& place) const {
    const double x = (place.longitude + 180.0) / 360.0 * m_picture.width - 0.5;
    const double y = (90.0 - place.latitude) / 180.0 * m_picture.height - 0.5;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const std::array<double, 4> across = splineWeights(x - left);
    const std::array<double, 4> down = splineWeights(y - top);
    MarbleColor sum;
    glm::dvec3 ofLand(0.0);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 color =
                texel(static_cast<std::int64_t>(left) + i - 1, static_cast<std::int64_t>(top) + j - 1);
            const double weight = across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)];
            sum.color += weight * color;
            const double water = waterOf(color);
            sum.water += weight * water;
            ofLand += weight * (1.0 - water) * color;
        }
    }
    // Else the sea beside it would make land blue, for kilometres.
    const double land = 1.0 - sum.water;
    sum.color = land > 1e-3 ? ofLand / land : sum.color;
    return sum;
}

} // namespace cdr::scenes
