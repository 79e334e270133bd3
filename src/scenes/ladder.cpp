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

namespace {

/// A cube of the ladder, its face to +z where it is however deep the cube is.
void addOne(scene::Scene& scene, const glm::dvec3& centre, const LadderOptions& options, double depth) {
    const auto side = static_cast<float>(options.scale);
    glm::mat3 basis(side);
    basis[2][2] = static_cast<float>(options.scale * depth);
    const glm::dvec3 forward(0.0, 0.0, 0.5 * options.scale * (1.0 - depth));
    addBox(scene, 0, centre + forward, basis);
}

} // namespace

scene::SceneSetup makeLadder(std::uint64_t seed, const LadderOptions& options) {
    constexpr std::uint32_t kColumns = 16;
    scene::SceneSetup setup{.scene = cubeScene("ladder", 32.0 * options.scale), .path = {}};
    setup.scene.lights.front().position = {0.0, 0.0, 64.0 * options.scale};
    Random random(seed);
    for (std::uint32_t pair = 0; pair < kLadderPairs; ++pair) {
        const std::uint32_t column = pair % kColumns;
        const std::uint32_t row = pair / kColumns;
        const glm::dvec3 back =
            options.scale * glm::dvec3(2.0 * column - 15.0, 15.0 - 2.0 * row, random.uniform(-0.5, 0.5));
        const glm::dvec3 front = back + glm::dvec3(0.0, 0.0, ladderSeparation(options, pair));
        const bool backFirst = random.uniform(0.0, 1.0) < 0.5;
        addOne(setup.scene, backFirst ? back : front, options, backFirst ? 1.0 : options.frontDepth);
        addOne(setup.scene, backFirst ? front : back, options, backFirst ? options.frontDepth : 1.0);
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
