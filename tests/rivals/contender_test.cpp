#include "../support/refusal.h"
#include "../support/shared_device.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>
#include <rivals/contender.h>

#include <cmath>

namespace {

using namespace cdr;
using namespace cdr::rivals;

constexpr vk::Extent2D kExtent{480, 270};

/// A generated scene and everything that contenders draw it with.
struct Arena {
    scene::SceneSetup setup;
    render::GpuScene uploaded;
    platform::WorkerPool workers{2};

    Arena(const gpu::Device& device, const std::string& name)
        : setup(scenes::openScene(name, scenes::kDefaultSeed).setup),
          uploaded(device, setup.scene) {}
    render::DrawnScene drawn() const { return {setup.scene, uploaded.uploaded()}; }
};

class Contenders : public test::DeviceTest {
  protected:
    Contender make(Arena& arena, const Competing& competing) {
        return {device(), arena.drawn(), competing, kExtent, arena.workers};
    }

    /// Those that the device can draw, each with a prepass and without.
    std::vector<NamedRival> drawable() {
        std::vector<NamedRival> all;
        for (const NamedRival& named : namedRivals()) {
            if (missingFeatures(device().info(), named.rival).empty()) {
                all.push_back(named);
                all.push_back(parseRival(named.name + "/prepass"));
            } else {
                leaveOut(named.name);
            }
        }
        return all;
    }

    measure::WrongPixels wrongIn(const FramePixels& surfaces, const Arena& arena,
                                 const scene::Camera& camera) {
        return measure::countWrong(surfaces.ids, measure::castTruth(arena.setup.scene, camera, kExtent.width,
                                                                    kExtent.height, m_workers));
    }

  private:
    platform::WorkerPool m_workers{2};
};

/// So what is said of them here holds of the frames of the library.
TEST_F(Contenders, DepthTestsShowTheIdsAndDistancesOfTheRenderer) {
    for (const char* scene : {"afc", "mixed", "rotation"}) {
        Arena arena(device(), scene);
        for (const auto& [name, technique] : depth::presets()) {
            Contender contender = make(arena, technique);
            render::Renderer renderer(
                device(), arena.setup.scene, arena.uploaded,
                {.width = kExtent.width, .height = kExtent.height, .technique = technique});
            const scene::Camera camera = arena.setup.path.at(0);
            const FramePixels surfaces = contender.render(camera);
            const render::Frame frame = renderer.render(camera);
            EXPECT_EQ(surfaces.ids, frame.ids()) << name << " in " << scene;
            EXPECT_EQ(contender.cascades(), frame.cascades.size()) << name << " in " << scene;
            std::size_t others = 0;
            for (std::uint32_t y = 0; y < kExtent.height; ++y) {
                for (std::uint32_t x = 0; x < kExtent.width; ++x) {
                    others += surfaces.distanceView.at(x, y) != frame.distanceView(x, y) ? 1 : 0;
                }
            }
            EXPECT_EQ(others, 0u) << name << " in " << scene;
        }
    }
}

/// Except for one-pass targets, whose slices of the depth range round in their own way.
TEST_F(Contenders, StandForEveryKindOfTargetsAndEverySubmission) {
    Arena arena(device(), "afc");
    const scene::Camera camera = arena.setup.path.at(40);
    std::vector<render::Submission> submissions{render::Submission::secondaries,
                                                render::Submission::primaries};
    if (canDrawGpuDriven()) {
        submissions.push_back(render::Submission::gpuDriven);
    }
    for (const auto& [name, technique] : depth::presets()) {
        Contender contender = make(arena, technique);
        const image::ImageU32 ids = contender.render(camera).ids;
        for (const render::TargetsKind targets : render::kTargetsKinds) {
            if (targets == render::TargetsKind::onePass) {
                continue;
            }
            for (const render::Submission submission : submissions) {
                render::Renderer renderer(device(), arena.setup.scene, arena.uploaded,
                                          {.width = kExtent.width,
                                           .height = kExtent.height,
                                           .technique = technique,
                                           .targets = targets,
                                           .submission = submission});
                EXPECT_EQ(renderer.render(camera).ids(), ids)
                    << name << " " << nameOf(targets) << " " << nameOf(submission);
            }
        }
    }
}

/// The distance decides what a rival resolves, and not the number of bits that are compared.
TEST_F(Contenders, DistancesFromTheObjectResolveWhatOnesFromTheCameraDoNot) {
    Arena arena(device(), "mixed");
    const scene::Camera camera = arena.setup.path.at(0);
    const auto wrongShare = [&](const Competing& competing) {
        return wrongIn(make(arena, competing).render(camera), arena, camera).fraction().value();
    };
    // Anchored depth is wrong only where the device's rounding of vertices tilts a face, and that strikes rivals as well.
    const double rounded = wrongShare(depth::namedTechnique("anchored").technique);
    for (const NamedRival& named : drawable()) {
        if (named.rival.distance == Distance::object) {
            EXPECT_LT(wrongShare(named.rival), rounded + 0.001) << named.name;
        } else {
            EXPECT_GT(wrongShare(named.rival), rounded + 0.005) << named.name;
        }
    }
}

TEST_F(Contenders, APrepassChangesNoPixel) {
    for (const char* scene : {"afc", "mixed", "rotation"}) {
        Arena arena(device(), scene);
        const scene::Camera camera = arena.setup.path.at(7 % arena.setup.path.frames);
        for (const NamedRival& named : drawable()) {
            if (named.rival.prepass) {
                continue;
            }
            Contender alone = make(arena, named.rival);
            Contender behind = make(arena, parseRival(named.name + "/prepass").rival);
            const FramePixels expected = alone.render(camera);
            const FramePixels sieved = behind.render(camera);
            EXPECT_EQ(sieved.ids, expected.ids) << named.name << " in " << scene;
            EXPECT_EQ(sieved.distanceView, expected.distanceView) << named.name << " in " << scene;
        }
    }
}

/// The second pass finds an id for each pixel that the first one found a distance for.
TEST_F(Contenders, ADistanceAndAnIdComeTogether) {
    Arena arena(device(), "rotation");
    const scene::Camera camera = arena.setup.path.at(0);
    for (const NamedRival& named : drawable()) {
        Contender contender = make(arena, named.rival);
        contender.draw(arena.setup.path.at(3)); // what it leaves must not be seen
        const FramePixels surfaces = contender.render(camera);
        std::size_t covered = 0;
        std::size_t torn = 0;
        for (std::size_t i = 0; i < surfaces.ids.pixels.size(); ++i) {
            const bool hasId = surfaces.ids.pixels[i] != 0;
            covered += hasId ? 1 : 0;
            torn += hasId != std::isfinite(surfaces.distanceView.pixels[i]) ? 1 : 0;
        }
        EXPECT_GT(covered, surfaces.ids.pixels.size() / 4) << named.name;
        EXPECT_EQ(torn, 0u) << named.name;
        EXPECT_EQ(contender.render(camera).ids, surfaces.ids) << named.name << " drawn again";
    }
}

TEST_F(Contenders, DistancesAreThoseOfTheTruth) {
    Arena arena(device(), "afc");
    const scene::Camera camera = arena.setup.path.at(0);
    platform::WorkerPool workers(2);
    const measure::TruthImage truth =
        measure::castTruth(arena.setup.scene, camera, kExtent.width, kExtent.height, workers);
    const image::Raster<std::uint8_t> inner = measure::innerMask(truth);
    for (const NamedRival& named : drawable()) {
        // A float32 holds 24 bits of a distance, and its interpolation rounds some more.
        const double allowed = named.rival.distance == Distance::object ? 2e-5 : 2.0;
        Contender contender = make(arena, named.rival);
        const FramePixels surfaces = contender.render(camera);
        double worst = 0.0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            if (inner.pixels[i] != 0 && surfaces.ids.pixels[i] == truth.pixels[i].id) {
                worst =
                    std::max(worst, std::abs(surfaces.distanceView.pixels[i] - truth.pixels[i].distanceView));
            }
        }
        std::printf("%s: distances off by %.3g at most\n", named.name.c_str(), worst);
        EXPECT_LT(worst, allowed) << named.name;
    }
}

TEST_F(Contenders, WhatADeviceOrASceneDoesNotAllowIsRefused) {
    Arena arena(device(), "afc");
    for (const NamedRival& named : namedRivals()) {
        if (const auto missing = missingFeatures(device().info(), named.rival); !missing.empty()) {
            const std::string message = cdr::test::inputErrorOf([&] { make(arena, named.rival); });
            EXPECT_NE(message.find(missing.front()), std::string::npos) << named.name << ": " << message;
        }
    }
    if (device().info().hasInt64Atomics) {
        EXPECT_THROW(make(arena, Rival{.distance = Distance::view, .key = Key::pair64}), base::InputError);
    }
    Arena layered(device(), "coplanar");
    EXPECT_THROW(make(layered, depth::parseTechnique("reversed")), base::InputError);
}

} // namespace
