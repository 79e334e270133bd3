#include <cdr/base/error.h>
#include <scenes/cube_scene.h>
#include <scenes/degree.h>
#include <scenes/random.h>
#include <scenes/traffic.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace cdr::scenes {

namespace {

constexpr double kNearestMover = 1.0;
constexpr double kFarthestMover = 1e7;
constexpr double kMoverWidth = 0.01; ///< of a cube, as a share of its distance

struct Mover {
    glm::dvec3 across; ///< the circle's axes, as long as it is wide
    glm::dvec3 along;
    glm::dvec3 axis; ///< of the spin, unit
    double begin;    ///< radians
    double pace;     ///< of the circle, radians a frame
    double spin;

    scene::Transform at(std::uint32_t frame) const {
        const double angle = begin + pace * frame;
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), spin * frame, axis);
        return {.position = std::cos(angle) * across + std::sin(angle) * along,
                .basis = glm::mat3(glm::dmat3(turn) * (kMoverWidth * glm::length(across)))};
    }
};

glm::dvec3 anyDirection(Random& random) {
    for (;;) {
        const glm::dvec3 point = random.inCube(1.0);
        const double length = glm::length(point);
        if (length > 0.1 && length <= 1.0) {
            return point / length;
        }
    }
}

Mover anyMover(Random& random) {
    const double distance = std::exp(random.uniform(std::log(kNearestMover), std::log(kFarthestMover)));
    const glm::dvec3 across = anyDirection(random);
    glm::dvec3 along = glm::cross(across, anyDirection(random));
    while (glm::length(along) < 0.1) {
        along = glm::cross(across, anyDirection(random));
    }
    const double begin = random.uniform(0.0, 360.0 * kDegree);
    const double pace = random.uniform(-0.2, 0.2) * kDegree;
    return {.across = distance * across,
            .along = distance * glm::normalize(along),
            .axis = anyDirection(random),
            .begin = begin,
            .pace = pace,
            .spin = random.uniform(-3.0, 3.0) * kDegree};
}

} // namespace

scene::SceneSetup makeTraffic(std::uint64_t seed, std::uint32_t movers) {
    if (movers > scene::kMaxObjects) {
        throw base::InputError("traffic: at most " + std::to_string(scene::kMaxObjects) + " movers");
    }
    scene::SceneSetup setup{.scene = cubeScene("traffic", 1e8), .path = {}};
    const auto all = std::make_shared<std::vector<Mover>>();
    Random random(seed);
    for (std::uint32_t i = 0; i < movers; ++i) {
        all->push_back(anyMover(random));
        const scene::Transform begin = all->back().at(0);
        scene::addInstance(setup.scene, 0, 0, i, begin.position, begin.basis);
    }
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 0.5, .farView = 2e7};
    setup.path = scene::turnPath(lens, glm::dvec3(0.0), 360);
    setup.motion.instances.resize(movers);
    std::iota(setup.motion.instances.begin(), setup.motion.instances.end(), 0u);
    setup.motion.transforms = [all](std::uint32_t frame) {
        std::vector<scene::Transform> transforms;
        transforms.reserve(all->size());
        for (const Mover& mover : *all) {
            transforms.push_back(mover.at(frame));
        }
        return transforms;
    };
    return setup;
}

} // namespace cdr::scenes
