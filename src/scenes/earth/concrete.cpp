#include <cdr/image/srgb.h>
#include <scenes/earth/concrete.h>
#include <scenes/earth/noise.h>

#include <algorithm>
#include <cmath>

namespace cdr::scenes {

namespace {

// Metres.
constexpr double kSlab = 60.0;
constexpr double kPlate = 6.0; ///< from joint to joint
constexpr double kJoint = 0.06;
constexpr Waves kGrain{.longest = 16.0, .shortest = 0.1, .gain = 0.85, .seed = 81};

double toJoint(double along) {
    return std::abs(along - kPlate * std::round(along / kPlate));
}

/// How much of a texel a joint covers.
double jointShare(const glm::dvec2& place, double texel) {
    const double distance = std::min(toJoint(place.x), toJoint(place.y));
    const double width = std::max(kJoint, texel);
    return kJoint / width * std::clamp(1.5 - distance / width, 0.0, 1.0);
}

double greyAt(const glm::dvec2& place, double texel) {
    const double plate = cellNumber(cellOf(place.x / kPlate), cellOf(place.y / kPlate), 82) - 0.5;
    const double grey = kConcreteMean * (1.0 + 0.1 * plate + 0.06 * sumWaves(kGrain, place, texel)) * 1.02;
    return grey * (1.0 - 0.5 * jointShare(place, texel));
}

} // namespace

image::ImageRgba8 paintConcrete(std::uint32_t side, platform::WorkerPool& workers) {
    const double texel = kSlab / side;
    image::ImageRgba8 picture(side, side);
    workers.run(side, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t x = 0; x < side; ++x) {
            const double grey = greyAt(texel * (glm::dvec2(x, y) + 0.5), texel);
            const std::uint8_t step = image::srgbOfLinear(std::clamp(grey, 0.0, 1.0));
            picture.at(x, y) = {step, step, step, 255};
        }
    });
    return picture;
}

} // namespace cdr::scenes
