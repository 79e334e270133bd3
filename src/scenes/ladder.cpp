#include <scenes/cube_scene.h>
#include <scenes/degree.h>
#include <scenes/ladder.h>
#include <scenes/random.h>

#include <cmath>

namespace cdr::scenes {

double ladderSeparation(const LadderOptions& options, std::uint32_t pair) {
    const double share = static_cast<double>(pair) / (kLadderPairs - 1);
    return options.scale * options.smallestSeparation *
           std::pow(options.largestSeparation / options.smallestSeparation, share);
}

scene::SceneSetup makeLadder(std::uint64_t seed, const LadderOptions& options) {
    constexpr std::uint32_t kColumns = 16;
    scene::SceneSetup setup{.scene = cubeScene("ladder", 32.0 * options.scale), .path = {}};
    setup.scene.lights.front().position = {0.0, 0.0, 64.0 * options.scale};
    const auto side = static_cast<float>(options.scale);
    Random random(seed);
    for (std::uint32_t pair = 0; pair < kLadderPairs; ++pair) {
        const std::uint32_t column = pair % kColumns;
        const std::uint32_t row = pair / kColumns;
        const glm::dvec3 back =
            options.scale * glm::dvec3(2.0 * column - 15.0, 15.0 - 2.0 * row, random.uniform(-0.5, 0.5));
        const glm::dvec3 front = back + glm::dvec3(0.0, 0.0, ladderSeparation(options, pair));
        const bool backFirst = random.uniform(0.0, 1.0) < 0.5;
        addCube(setup.scene, backFirst ? back : front, side);
        addCube(setup.scene, backFirst ? front : back, side);
    }
    const double halfHeight = 18.0 * options.scale;
    const scene::Camera lens{.fovY = 2.0 * std::atan(halfHeight / options.distanceView),
                             .nearView = options.nearView,
                             .farView = options.farView};
    const double angle = 20.0 * kDegree;
    const glm::dvec3 eye = options.distanceView * glm::dvec3(std::sin(angle), 0.0, std::cos(angle));
    setup.path = scene::stillPath(scene::lookAt(lens, eye, glm::dvec3(0.0)));
    return setup;
}

} // namespace cdr::scenes
