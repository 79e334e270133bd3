#include "snapping.h"

#include "../support/worst.h"
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace cdr::render_test {

namespace {

using measure::TruthImage;
using measure::TruthPixel;

/// A grid of boxes, each turned its own way.
scene::Scene turnedBoxes() {
    scene::Scene scene = boxScene();
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> angle(0.0, 6.0);
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 away(std::cos(angle(random)), std::sin(angle(random)), std::sin(angle(random)));
        const scene::Camera turned = scene::lookAt({}, glm::dvec3(0.0), away);
        addBox(scene, {1.7 * (i % 8 - 3.5), 1.7 * (i / 8 - 2.0), -20.0},
               glm::mat3(glm::dmat3(turned.right, turned.up, turned.back)));
    }
    return scene;
}

/// Slopes of 1 / w along x and y, which are constant over a plane; none where the neighbours show another face.
std::optional<glm::dvec2> planeSlope(const TruthImage& truth, std::uint32_t x, std::uint32_t y) {
    const auto inverse = [&](std::uint32_t column, std::uint32_t row) {
        return 1.0 / truth.at(column, row).distanceView;
    };
    const double here = inverse(x, y);
    const double bendX = inverse(x - 1, y) + inverse(x + 1, y) - 2.0 * here;
    const double bendY = inverse(x, y - 1) + inverse(x, y + 1) - 2.0 * here;
    if (std::abs(bendX) + std::abs(bendY) > 1e-12 * here) {
        return std::nullopt;
    }
    return glm::dvec2(inverse(x + 1, y) - here, inverse(x, y + 1) - here);
}

/// The largest step of a distance to the four neighbours along one axis each, added up; infinite where one is.
template <typename Distance>
double slopeAround(const TruthImage& truth, std::uint32_t x, std::uint32_t y, Distance distance) {
    const double here = distance(truth.at(x, y));
    const auto step = [&](std::uint32_t column, std::uint32_t row) {
        return std::abs(distance(truth.at(column, row)) - here);
    };
    return std::max(step(x - 1, y), step(x + 1, y)) + std::max(step(x, y - 1), step(x, y + 1));
}

} // namespace

double halfSubPixel(std::uint32_t bits) {
    return std::exp2(-1.0 - bits);
}

double measureReach(const gpu::Device& device, std::uint32_t snapBits, render::Snapping snapping) {
    const scene::Scene scene = turnedBoxes();
    const scene::Camera camera{.fovY = 0.5, .nearView = 1.0, .farView = 100.0};
    auto options = smallOptions(depth::parseTechnique("anchored"));
    options.snapBits = snapBits;
    options.snapping = snapping;
    const render::Frame frame = SoleRenderer(device, scene, options).render(camera);
    const TruthImage truth = truthOf(scene, camera, options.width, options.height);
    const auto inner = measure::innerMask(truth);
    double farthest = 0.0;
    for (std::uint32_t y = 1; y + 1 < truth.height; ++y) {
        for (std::uint32_t x = 1; x + 1 < truth.width; ++x) {
            const bool isMeasured = inner.at(x, y) != 0 && truth.at(x, y).id != 0;
            const auto slope = isMeasured ? planeSlope(truth, x, y) : std::nullopt;
            if (slope) {
                const double error = 1.0 / frame.distanceView(x, y) - 1.0 / truth.at(x, y).distanceView;
                farthest =
                    test::worseOf(farthest, std::abs(error) / (std::abs(slope->x) + std::abs(slope->y)));
            }
        }
    }
    return farthest;
}

double snapReach(const gpu::Device& device) {
    const double promised = halfSubPixel(device.info().subPixelBits);
    static const double measured = measureReach(device, 0);
    return measured < 0.1 * promised ? 0.0 : promised;
}

bool drawsToTheHorizon(const gpu::Device& device) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, -2.5, 0.0}, glm::mat3(2e4f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 2e4f));
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.01, .farView = 1e6};
    const auto options = smallOptions(depth::parseTechnique("reversed"));
    const render::Frame frame = SoleRenderer(device, scene, options).render(camera);
    const TruthImage truth = truthOf(scene, camera, options.width, options.height);
    const auto inner = measure::innerMask(truth);
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const double right = truth.at(x, y).distanceView;
            const bool isFloor = inner.at(x, y) != 0 && truth.at(x, y).id != 0;
            // What is no number is wrong too.
            if (isFloor && !(std::abs(frame.distanceView(x, y) - right) <= 0.01 * right)) {
                return false;
            }
        }
    }
    return true;
}

image::Raster<std::uint8_t> swappable(const TruthImage& truth, double reachPixels) {
    auto mask = measure::innerMask(truth);
    for (std::uint32_t y = 1; y + 1 < truth.height; ++y) {
        for (std::uint32_t x = 1; x + 1 < truth.width; ++x) {
            const TruthPixel& pixel = truth.at(x, y);
            const double slope =
                slopeAround(truth, x, y, [](const TruthPixel& p) { return p.distanceView; }) +
                slopeAround(truth, x, y, [](const TruthPixel& p) { return p.secondDistanceView; });
            const bool close =
                pixel.secondId != 0 && pixel.secondDistanceView - pixel.distanceView < reachPixels * slope;
            mask.at(x, y) &= static_cast<std::uint8_t>(close ? 1 : 0);
        }
    }
    return mask;
}

std::uint64_t wrongBeyond(const image::ImageU32& ids, const TruthImage& truth, double reachPixels) {
    const auto inner = measure::innerMask(truth);
    const auto excused = swappable(truth, reachPixels);
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
        const TruthPixel& pixel = truth.pixels[i];
        const bool isSecond = ids.pixels[i] == pixel.secondId && excused.pixels[i] != 0;
        wrong += inner.pixels[i] != 0 && ids.pixels[i] != pixel.id && !isSecond ? 1 : 0;
    }
    return wrong;
}

} // namespace cdr::render_test
