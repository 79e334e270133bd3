#include <cdr/render/shadows/receiver_slices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cdr::render_test {

namespace {

using render::SeenSphere;

std::vector<SeenSphere> occupiedSpheres(const scene::Camera& camera,
                                        const std::vector<depth::Interval>& occupied) {
    std::vector<SeenSphere> seen;
    render::addOccupied(seen, camera, scene::frustumOf(camera, 1280, 720), occupied);
    return seen;
}

/// Narrow, usual and wide ones, and one that is shifted by more than its width.
std::vector<scene::Camera> lenses() {
    std::vector<scene::Camera> cameras;
    for (const double fovY : {1e-4, 1.0, 3.1}) {
        cameras.push_back({.fovY = fovY, .nearView = 0.1, .farView = 1e4});
    }
    cameras.push_back(cameras[1]);
    cameras.back().lensShift = {2.0, -1.5};
    return cameras;
}

TEST(Occupied, EveryPlaceInThePictureAtTheseDistancesIsInASphere) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (const scene::Camera& camera : lenses()) {
        const scene::Frustum frustum = scene::frustumOf(camera, 1280, 720);
        for (const depth::Interval& interval :
             {depth::Interval{10.0, 10.0}, depth::Interval{3.0, 50.0}, depth::Interval{0.1, 1e4}}) {
            const std::vector<SeenSphere> seen = occupiedSpheres(camera, {interval});
            for (int i = 0; i < 2000; ++i) {
                const double view =
                    interval.nearView + (0.5 + 0.5 * share(random)) * (interval.farView - interval.nearView);
                const glm::dvec2 ray =
                    frustum.centre + glm::dvec2(share(random) * frustum.tanX, share(random) * frustum.tanY);
                const glm::dvec3 place =
                    camera.right * (ray.x * view) + camera.up * (ray.y * view) - camera.back * view;
                EXPECT_TRUE(std::any_of(seen.begin(), seen.end(),
                                        [&](const SeenSphere& sphere) {
                                            return glm::distance(sphere.centre, place) <=
                                                   sphere.radius * (1.0 + 1e-9);
                                        }))
                    << camera.fovY << " at " << view;
            }
        }
    }
}

TEST(Occupied, ManyIntervalsBecomeNoMoreSpheresThanOneAroundThem) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e4};
    std::vector<depth::Interval> many;
    for (int i = 0; i < 100'000; ++i) {
        many.push_back({1.0 + 0.01 * i, 1.005 + 0.01 * i});
    }
    const std::vector<SeenSphere> one = occupiedSpheres(camera, {{1.0, many.back().farView}});
    EXPECT_GT(one.size(), 5u);
    EXPECT_LT(one.size(), 1000u);
    EXPECT_LE(occupiedSpheres(camera, many).size(), one.size());
}

TEST(Occupied, WhatTheCameraDoesNotShowIsLeftOut) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e4};
    EXPECT_TRUE(occupiedSpheres(camera, {}).empty());
    EXPECT_TRUE(occupiedSpheres(camera, {{-5.0, 0.05}, {2e4, 3e4}}).empty());
    EXPECT_FALSE(occupiedSpheres(camera, {{-5.0, 0.1}, {1e4, 3e4}}).empty());
}

} // namespace

} // namespace cdr::render_test
