#include "../../support/all_cases.h"
#include "../../support/worst.h"
#include "../fixture.h"
#include "../host/host_side.h"
#include "../host/read_image.h"
#include "held.h"
#include "truth_motion.h"

#include <cdr/base/error.h>
#include <cdr/shaders/motion_shared.h>
#include <scenes/cubes.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace cdr::render_test {

namespace {

/// So far apart, in widths of a pixel, points need no slack for what lies between them.
constexpr double kAlikePixels = 0.02;
constexpr float kNoMotion = 1e30f; // CDR_NO_MOTION of cdr_gbuffer.glsl

glm::mat3 turned(double angle, const glm::dvec3& axis, double size) {
    return glm::mat3(glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, axis)) * size);
}

/// Boxes side by side, as wide as they are apart, so many units in front of the origin.
struct FarWorld {
    scene::World world{boxScene()};
    std::vector<scene::InstanceHandle> boxes;
    std::vector<scene::Transform> places;
    double distanceView;
    double size;

    FarWorld(double distance, double side) : distanceView(distance), size(side) {
        for (int i = 0; i < 9; ++i) {
            places.push_back(
                {.position = {side * (i % 3 - 1), side * (i / 3 - 1), -distance - 0.1 * side * i},
                 .basis = glm::mat3(static_cast<float>(side * 0.8))});
            boxes.push_back(world.addInstance({.mesh = world.mesh(0),
                                               .material = world.material(0),
                                               .object = static_cast<std::uint32_t>(i),
                                               .transform = places.back()}));
        }
    }
    /// All but the first.
    void move(std::mt19937& random) {
        std::uniform_real_distribution<double> share(-0.2, 0.2);
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            places[i].position += size * glm::dvec3(share(random), share(random), share(random));
            places[i].basis =
                turned(share(random), glm::normalize(glm::dvec3(share(random), 1.0, share(random))), 1.0) *
                places[i].basis;
        }
        world.setTransforms(boxes, places);
    }
};

/// Looks at the boxes from somewhere beside the origin, as far as they are away.
scene::Camera orbiting(const FarWorld& far, double fovY, double angle) {
    const glm::dvec3 target{0.0, 0.0, -far.distanceView};
    const glm::dvec3 eye =
        target + far.distanceView * glm::dvec3(std::sin(angle), 0.1 * angle, std::cos(angle));
    return scene::lookAt({.fovY = fovY, .nearView = 0.1, .farView = 4.0 * far.distanceView}, eye, target);
}

class MotionTest : public RenderTest {
  protected:
    static render::RenderOptions options(const char* technique = "anchored") {
        render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
        options.motion = true;
        return options;
    }

    /// How far a frame's motion is off the truth. It is measured for the points that the truth's own rays meet. It is also
    /// measured for the points that the frame holds, since devices that snap vertices move these.
    struct Difference {
        double most =
            0.0; ///< pixels; of motion longer than 10^4, less what one part in a million has more than 0.01
        double longest = 0.0;
        std::size_t pixels = 0; ///< that show a surface by the truth
        struct Share {
            std::size_t pixels = 0;
            std::size_t compared = 0; ///< with the truth's own rays
        };
        std::array<Share, 2> shares{}; ///< of objects that stand still, and of those that move

        double leastCompared() const {
            double least = 1.0;
            for (const Share& share : shares) {
                if (share.pixels != 0) {
                    least = std::min(least,
                                     static_cast<double>(share.compared) / static_cast<double>(share.pixels));
                }
            }
            return least;
        }

        void add(const glm::vec2& motion, const glm::dvec2& exact, double slack = 0.0) {
            const double length = glm::length(exact);
            const double off =
                glm::length(glm::dvec2(motion) - exact) - 1e-6 * std::max(length - 1e4, 0.0) - slack;
            most = test::worseOf(most, off);
            longest = std::max(longest, length);
        }
    };
    Difference compare(const render::Frame& frame, const SeenScene& now, const SeenScene& before) {
        const measure::TruthImage truth = truthOf(now.scene, now.camera, frame.width(), frame.height());
        const measure::TruthImage held = heldBy(frame);
        const image::Raster<glm::dvec2> ofTruth = truthMotion(truth, now, before);
        const image::Raster<glm::dvec2> ofHeld = truthMotion(held, now, before);
        std::set<std::uint32_t> moving; // ids
        for (std::size_t i = 0; i < now.scene.instances.size(); ++i) {
            if (now.scene.instances.position(i) != before.scene.instances.position(i) ||
                now.scene.instances.basis[i] != before.scene.instances.basis[i]) {
                moving.insert(now.scene.instances.object[i] + 1);
            }
        }
        // Two steps of the device's vertices apart is the same point. On a surface that turned by a fifth, motion is then off
        // by a little more than a fifth of what they are apart.
        const double mostApart =
            std::max(kAlikePixels, std::ldexp(2.0, -static_cast<int>(device().info().subPixelBits)));
        const double pixelSlope = 2.0 * std::tan(0.5 * now.camera.fovY) / frame.height();
        Difference difference;
        for (std::size_t i = 0; i < held.pixels.size(); ++i) {
            const measure::TruthPixel& exact = truth.pixels[i];
            if (held.pixels[i].id != 0) {
                difference.add(frame.motion.pixels[i], ofHeld.pixels[i]);
            }
            if (exact.id == 0) {
                continue;
            }
            ++difference.pixels;
            Difference::Share& share = difference.shares[moving.count(exact.id)];
            ++share.pixels;
            const double apart = std::abs(held.pixels[i].distanceView - exact.distanceView) /
                                 (pixelSlope * exact.distanceView);
            if (held.pixels[i].id == exact.id && apart < mostApart) {
                ++share.compared;
                difference.add(frame.motion.pixels[i], ofTruth.pixels[i],
                               0.3 * std::max(apart - kAlikePixels, 0.0));
            }
        }
        return difference;
    }
    /// Draws, moves what there is, draws again, and compares.
    Difference differenceOf(const FarWorld& far, const scene::Camera& before, const scene::Camera& now,
                            const auto& move, const char* technique = "anchored") {
        SoleRenderer renderer(device(), far.world, options(technique));
        renderer.render(before);
        const scene::Scene sceneBefore = far.world.scene();
        move();
        return compare(renderer.render(now), {far.world.scene(), now}, {sceneBefore, before});
    }

    static void expectExact(const Difference& difference, std::size_t leastPixels = 20'000) {
        EXPECT_GT(difference.pixels, leastPixels);
        EXPECT_LT(difference.most, 0.01);
        EXPECT_GT(difference.leastCompared(), 0.9);
    }
};

TEST_F(MotionTest, IsExactToAHundredthOfAPixelAMillionUnitsAway) {
    std::mt19937 random(5);
    for (const double fovY : {1e-5, 1e-4}) {
        FarWorld far(1e6, 0.25 * fovY * 1e6);
        SoleRenderer renderer(device(), far.world, options());
        scene::Camera before = orbiting(far, fovY, 0.0);
        renderer.render(before);
        for (int turn = 1; turn < 5; ++turn) {
            const scene::Scene sceneBefore = far.world.scene();
            // Turns about the boxes, a thousand times as far as the picture is wide, and moves them too.
            const scene::Camera now = orbiting(far, fovY * (turn == 3 ? 1.1 : 1.0), 0.01 * turn);
            far.move(random);
            const render::Frame frame = renderer.render(now);
            const Difference difference = compare(frame, {far.world.scene(), now}, {sceneBefore, before});
            SCOPED_TRACE(testing::Message() << fovY << " turn " << turn);
            expectExact(difference);
            EXPECT_GT(difference.longest, 5.0);
            before = now;
        }
    }
}

/// From a million pixels beside the picture.
TEST_F(MotionTest, IsExactToAMillionthWhereItIsLong) {
    const double fovY = 1e-5;
    FarWorld far(1e6, 0.25 * fovY * 1e6);
    const auto moveAside = [&](double right) {
        for (std::size_t i = 1; i < far.places.size(); ++i) {
            far.places[i].position.x += right;
        }
        far.world.setTransforms(far.boxes, far.places);
    };
    moveAside(4e4);
    const scene::Camera camera = orbiting(far, fovY, 0.1);
    const Difference difference = differenceOf(far, camera, camera, [&] { moveAside(-4e4); });
    expectExact(difference);
    EXPECT_GT(difference.longest, 1e6);
}

TEST_F(MotionTest, IsExactForEveryTechniqueNearBy) {
    std::mt19937 random(6);
    for (const char* technique : {"standard", "reversed", "log", "cdr", "anchored"}) {
        SCOPED_TRACE(technique);
        FarWorld far(50.0, 12.0);
        expectExact(differenceOf(
            far, orbiting(far, 0.8, 0.0), orbiting(far, 0.8, 0.05), [&] { far.move(random); }, technique));
    }
}

TEST_F(MotionTest, IsExactThroughLensesThatAreShifted) {
    std::mt19937 random(8);
    for (const double distance : {50.0, 1e6}) {
        const double fovY = 40.0 / distance;
        FarWorld far(distance, 12.0);
        scene::Camera before = orbiting(far, fovY, 0.0);
        before.lensShift = glm::dvec2(0.2, -0.1) * fovY;
        scene::Camera now = orbiting(far, 1.1 * fovY, 0.02);
        now.lensShift = glm::dvec2(-0.1, 0.05) * fovY;
        const Difference difference = differenceOf(far, before, now, [&] { far.move(random); });
        SCOPED_TRACE(distance);
        expectExact(difference);
        EXPECT_GT(difference.longest, 50.0);
    }
}

TEST_F(MotionTest, WhatStandsStillDoesNotMoveToTheBit) {
    FarWorld far(1e6, 2.0);
    SoleRenderer renderer(device(), far.world, options());
    const scene::Camera camera = orbiting(far, 1e-5, 0.3);
    for (int turn = 0; turn < 2; ++turn) {
        const render::Frame frame = renderer.render(camera);
        EXPECT_TRUE(std::all_of(frame.motion.pixels.begin(), frame.motion.pixels.end(),
                                [](const glm::vec2& motion) { return motion == glm::vec2(0.0f); }));
    }
    renderer.render(orbiting(far, 1e-5, 0.1));
    renderer.forgetFrames();
    EXPECT_EQ(renderer.render(camera).motion.at(240, 135), glm::vec2(0.0f));
}

TEST_F(MotionTest, BackgroundMovesAsWhatIsInfinitelyFar) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, 100.0}); // behind the camera
    SoleRenderer renderer(device(), scene, options());
    scene::Camera camera{.fovY = 0.5};
    renderer.render(camera);
    camera.position = {3.0, 4.0, 5.0}; // of no matter
    const double angle = 0.01;
    camera = scene::lookAlong(camera, camera.position, {std::sin(angle), 0.0, -std::cos(angle)});
    const render::Frame frame = renderer.render(camera);
    // A turn to the right: what is in the middle was right of it.
    const double slope = std::tan(angle + std::atan(std::tan(0.25) / 270.0)) - std::tan(0.25) / 270.0;
    EXPECT_NEAR(frame.motion.at(240, 134).x, slope / std::tan(0.25) * 135.0, 1e-3);
}

TEST_F(MotionTest, AllWaysToDrawAFrameGiveTheSameMotion) {
    std::vector<image::Raster<glm::vec2>> motions;
    for (const render::Submission submission : submissions()) {
        for (const render::TargetsKind targets : {render::TargetsKind::single, render::TargetsKind::layers}) {
            std::mt19937 random(7);
            FarWorld far(1e6, 2.0);
            render::RenderOptions chosen = options();
            chosen.submission = submission;
            chosen.targets = targets;
            chosen.threads = targets == render::TargetsKind::layers ? 3 : 1;
            chosen.framesInFlight = 3;
            SoleRenderer renderer(device(), far.world, chosen);
            for (int turn = 0; turn < 5; ++turn) {
                far.move(random);
                renderer.submit(orbiting(far, 1e-5, 0.01 * turn));
            }
            far.world.setTransform(far.boxes[0], {.position = {0.5, 0.0, -1e6}, .basis = glm::mat3(1.5f)});
            motions.push_back(renderer.render(orbiting(far, 1e-5, 0.04)).motion);
        }
    }
    for (const auto& motion : motions) {
        EXPECT_EQ(motion, motions.front());
    }
}

TEST_F(MotionTest, AVisibilityBufferHasMotionToo) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    render::RenderOptions chosen = options();
    chosen.surface = render::SurfacePath::visibility;
    SoleRenderer renderer(device(), setup.scene, chosen);
    renderer.render(setup.path.at(0));
    const render::Frame frame = renderer.render(setup.path.at(1));
    const scene::Camera before = setup.path.at(0);
    const scene::Camera now = setup.path.at(1);
    const Difference difference = compare(frame, {setup.scene, now}, {setup.scene, before});
    expectExact(difference, 5'000);
    EXPECT_GT(difference.longest, 0.5);
}

TEST_F(MotionTest, WhatWasBehindTheCameraHasNone) {
    scene::World world(boxScene());
    const auto box = world.addInstance(
        {.mesh = world.mesh(0), .material = world.material(0), .transform = {{0.0, 0.0, 4.0}}});
    SoleRenderer renderer(device(), world, options());
    renderer.render({.fovY = 0.5});
    world.setTransform(box, {{0.0, 0.0, -4.0}});
    EXPECT_EQ(renderer.render({.fovY = 0.5}).motion.at(240, 135), glm::vec2(kNoMotion));
}

TEST_F(MotionTest, WhatIsNewDidNotMove) {
    FarWorld far(1e6, 2.0);
    SoleRenderer renderer(device(), far.world, options());
    const scene::Camera camera = orbiting(far, 1e-5, 0.0);
    renderer.render(camera);
    const scene::Transform elsewhere{.position = {0.1, 0.1, -1e6 + 5.0}, .basis = glm::mat3(2.0f)};
    far.world.removeInstance(far.boxes[4]);
    const auto added = far.world.addInstance(
        {.mesh = far.world.mesh(0), .material = far.world.material(0), .object = 4, .transform = elsewhere});
    ASSERT_EQ(added.index, far.boxes[4].index); // the place that was given back
    EXPECT_EQ(renderer.render(camera).motion.at(240, 135), glm::vec2(0.0f));
    far.world.setTransform(added, {.position = {0.2, 0.1, -1e6 + 5.0}, .basis = glm::mat3(2.0f)});
    EXPECT_LT(renderer.render(camera).motion.at(240, 135).x, -1.0f); // it was to the left
}

TEST_F(MotionTest, PartsOfAnObjectMoveAsOneOrAreRefused) {
    scene::World world(boxScene());
    std::vector<scene::InstanceHandle> parts;
    for (const double x : {-0.6, 0.6}) {
        parts.push_back(world.addInstance({.mesh = world.mesh(0),
                                           .material = world.material(0),
                                           .object = 7,
                                           .transform = {{x, 0.0, -6.0}}}));
    }
    SoleRenderer renderer(device(), world, options());
    const scene::Camera camera{.fovY = 0.5};
    renderer.render(camera);
    const glm::mat3 turn = turned(0.2, {0.0, 0.0, 1.0}, 1.0);
    const auto place = [&](double x) {
        return scene::Transform{glm::dvec3(turn * glm::vec3(x, 0.0f, 0.0f)) + glm::dvec3(0.0, 0.0, -6.0),
                                turn};
    };
    world.setTransforms(parts, std::vector{place(-0.6), place(0.6)});
    const render::Frame frame = renderer.render(camera);
    EXPECT_LT(frame.motion.at(180, 140).y, -1.0f); // the left part went down, so it was above
    EXPECT_GT(frame.motion.at(300, 130).y, 1.0f);
    world.setTransform(parts[0], place(-0.7));
    EXPECT_THROW(renderer.render(camera), base::InputError); // the other one stood still
    renderer.render(camera);
    world.setTransforms(parts, std::vector{place(-0.6), place(0.8)});
    EXPECT_THROW(renderer.render(camera), base::InputError);
    EXPECT_EQ(renderer.render(camera).motion.at(180, 140), glm::vec2(0.0f));
}

/// As engines hide things, draw cards, and scale above a part's own rotation.
TEST_F(MotionTest, FlatHiddenAndStretchedPartsMoveAsOneToo) {
    const glm::mat3 stretch(glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1000.0f, 0.0f),
                            glm::vec3(0.0f, 0.0f, 1.0f));
    const glm::mat3 flat(glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    const glm::mat3 turn = turned(0.3, {0.0, 0.6, 0.8}, 1.0);
    const std::vector<std::pair<glm::mat3, glm::mat3>> moves{{glm::mat3(1.0f), glm::mat3(0.0f)}, // hidden
                                                             {glm::mat3(1.0f), glm::mat3(0.001f)},
                                                             {flat, flat}, // a card
                                                             {stretch, turn * stretch}};
    for (const auto& [before, after] : moves) {
        scene::World world(boxScene());
        const auto place = [&](const glm::mat3& parent, int part, double right) {
            const glm::vec3 at(part == 0 ? -0.6f : 0.6f, 0.01f, 0.0f);
            const glm::mat3 own = turned(0.7 * part + 0.1, {0.6, 0.0, 0.8}, 0.3);
            return scene::Transform{glm::dvec3(parent * at) + glm::dvec3(right, 0.0, -6.0), parent * own};
        };
        std::vector<scene::InstanceHandle> parts;
        for (int part = 0; part < 2; ++part) {
            parts.push_back(world.addInstance({.mesh = world.mesh(0),
                                               .material = world.material(0),
                                               .object = 7,
                                               .transform = place(before, part, 0.0)}));
        }
        SoleRenderer renderer(device(), world, options());
        const scene::Camera camera{.fovY = 0.5};
        renderer.render(camera);
        for (const double right : {0.2, 0.3}) {
            world.setTransforms(parts, std::vector{place(after, 0, right), place(after, 1, right)});
            EXPECT_NO_THROW(renderer.render(camera)) << after[1][1];
        }
        world.setTransforms(parts, std::vector{place(after, 0, 0.4), place(after, 1, 0.7)});
        EXPECT_THROW(renderer.render(camera), base::InputError) << after[1][1];
    }
}

TEST_F(MotionTest, GoesIntoAHostsImage) {
    std::mt19937 random(8);
    FarWorld far(1e6, 2.0);
    render::GpuScene onDevice(device(), far.world);
    render::Renderer renderer(device(), onDevice, options());
    render::Renderer reference(device(), onDevice, options());
    HostSide host(device(), {480, 270}, vk::Format::eR8G8B8A8Srgb);
    const gpu::Image into(device(),
                          {.extent = {480, 270},
                           .format = vk::Format::eR32G32Sfloat,
                           .usage = vk::ImageUsageFlagBits::eTransferDst |
                                    vk::ImageUsageFlagBits::eTransferSrc |
                                    vk::ImageUsageFlagBits::eSampled}, // which its view asks for
                          "host motion");
    render::SurfaceImage image{.image = into.handle(),
                               .format = VK_FORMAT_R32G32_SFLOAT,
                               .extent = {480, 270},
                               .layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
    for (int turn = 0; turn < 2; ++turn) {
        const scene::Camera camera = orbiting(far, 1e-5, 0.01 * turn);
        render::HostFrame frame = host.begin();
        frame.motion = image;
        host.submit(renderer, camera, frame);
        renderer.finish();
        const render::Frame expected = reference.render(camera);
        EXPECT_EQ(
            readImage<glm::vec2>(device(), into.handle(), {480, 270}, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
                .pixels,
            expected.motion.pixels);
        EXPECT_EQ(renderer.surfaces().motion.format, VK_FORMAT_R32G32_SFLOAT);
        far.move(random);
    }
    render::HostFrame frame = host.begin();
    for (const VkFormat format : {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R16_SFLOAT}) {
        image.format = format;
        frame.motion = image;
        EXPECT_THROW(renderer.record(orbiting(far, 1e-5, 0.0), frame), base::InputError) << format;
    }
}

/// So many objects move that room for half as much again is more than a storage buffer may have.
TEST_F(MotionTest, RoomStaysWithinTheDevicesBuffers) {
    const std::size_t most = device().info().maxStorageBufferBytes / sizeof(shaders::MotionRecord);
    const std::size_t count = most / 10 * 7;
    if (!test::takesAllCases() || count > 2'000'000) {
        GTEST_SKIP()
            << "all cases are not taken (CDR_ALL_CASES), or buffers of the device hold over 2,000,000 records";
    }
    scene::Scene scene = boxScene();
    for (std::size_t i = 0; i < count; ++i) {
        addBox(scene, {0.0, 500.0, 50.0}); // behind the camera
    }
    scene::World world(std::move(scene));
    render::RenderOptions chosen = thumbnailOptions(depth::parseTechnique("reversed"));
    chosen.motion = true;
    SoleRenderer renderer(device(), world, chosen);
    renderer.draw({});
    std::vector<scene::InstanceHandle> all;
    for (std::uint32_t i = 0; i < count; ++i) {
        all.push_back(world.instance(i));
    }
    world.setTransforms(all, std::vector<scene::Transform>(count, {.position = {0.0, 501.0, 50.0}}));
    renderer.draw({});
    EXPECT_EQ(messageCount(), 0u);
}

TEST_F(MotionTest, OffIsNotThere) {
    render::RenderOptions chosen = options();
    chosen.motion = false;
    FarWorld far(1e6, 2.0);
    render::GpuScene onDevice(device(), far.world);
    render::Renderer renderer(device(), onDevice, chosen);
    EXPECT_TRUE(renderer.render(orbiting(far, 1e-5, 0.0)).motion.pixels.empty());
    EXPECT_EQ(renderer.surfaces().motion.image, VkImage(VK_NULL_HANDLE));
    HostSide host(device(), {480, 270}, vk::Format::eR8G8B8A8Srgb);
    render::HostFrame frame = host.begin();
    frame.motion = frame.color;
    EXPECT_THROW(renderer.record(orbiting(far, 1e-5, 0.0), frame), base::InputError);
    chosen.motion = true;
    chosen.targets = render::TargetsKind::layers;
    chosen.focus = {.distance = 10.0, .aperture = 0.1};
    EXPECT_THROW(render::Renderer(device(), onDevice, chosen), base::InputError);
}

} // namespace

} // namespace cdr::render_test
