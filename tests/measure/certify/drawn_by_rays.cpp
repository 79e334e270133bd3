#include "drawn_by_rays.h"

#include "../test_scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace cdr::test {

measure::DrawnFrame drawnByRays(const scene::Scene& scene, const scene::Camera& camera, double snapPixels,
                                const RayDevice& device) {
    // Of 9 x 9 rays a pixel the middle one is its own.
    const std::uint32_t rays = device.isOff ? 9 : 1;
    const measure::TruthImage truth = cast(scene, camera, rays * device.width, rays * device.height);
    measure::DrawnFrame frame{.camera = camera,
                              .technique = depth::parseTechnique("anchored"),
                              .cascades = {},
                              .ids = image::ImageU32(device.width, device.height),
                              .distancesView = image::Raster<double>(device.width, device.height),
                              .snapPixels = snapPixels};
    depth::Cascade& content = frame.cascades.emplace_back(depth::Cascade{camera.farView, camera.nearView});
    for (const measure::TruthPixel& seen : truth.pixels) {
        if (seen.id != 0) {
            content.nearView = std::min(content.nearView, 0.9 * seen.distanceView);
            content.farView = std::max(content.farView, 1.1 * seen.distanceView);
        }
    }
    std::mt19937 random(2013);
    for (std::uint32_t y = 0; y < device.height; ++y) {
        for (std::uint32_t x = 0; x < device.width; ++x) {
            const std::uint32_t column = device.isOff ? 3 + static_cast<std::uint32_t>(random() % 3) : 0;
            const std::uint32_t row = device.isOff ? 3 + static_cast<std::uint32_t>(random() % 3) : 0;
            const measure::TruthPixel& seen = truth.at(rays * x + column, rays * y + row);
            frame.ids.at(x, y) = seen.id;
            frame.distancesView.at(x, y) = seen.distanceView;
        }
    }
    return frame;
}

std::uint64_t shownBy(const measure::DrawnFrame& frame, std::uint32_t id) {
    return static_cast<std::uint64_t>(std::count(frame.ids.pixels.begin(), frame.ids.pixels.end(), id));
}

measure::Certificate certified(const scene::Scene& scene, const measure::DrawnFrame& frame,
                               std::size_t threads) {
    platform::WorkerPool workers(threads);
    return measure::Certifier(scene, workers).certify(frame, workers);
}

std::uint64_t wrongAfter(const scene::Scene& scene, const measure::DrawnFrame& frame,
                         const measure::Certificate& certificate) {
    image::ImageU32 ids = frame.ids;
    const measure::TruthImage truth = cast(scene, frame.camera, ids.width, ids.height);
    std::uint64_t wrong = 0;
    for (const measure::PixelRepair& repair : certificate.repairs) {
        ids.at(repair.x, repair.y) = repair.id;
        const double normalLength = repair.id != 0 ? glm::length(repair.normal) : 1.0;
        const bool isPlaced = repair.distanceView == truth.at(repair.x, repair.y).distanceView;
        wrong += isPlaced && std::abs(normalLength - 1.0) < 1e-6 ? 0 : 1;
    }
    for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
        wrong += ids.pixels[i] != truth.pixels[i].id ? 1 : 0;
    }
    return wrong;
}

} // namespace cdr::test
