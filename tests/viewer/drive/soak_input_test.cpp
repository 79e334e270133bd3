#include <viewer/drive/soak_input.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/camera/orbit_controller.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr int kSteps = 30 * 60 * 20; // 20 minutes

/// Everything in a step that a soak acts on, as text.
std::string textOf(const SoakStep& step) {
    const CameraInput& input = step.input;
    std::string text;
    for (const double value : {input.drag.x, input.drag.y, input.pan.x, input.cursor.x, input.cursor.y,
                               input.scroll, input.seconds, static_cast<double>(input.extent.width)}) {
        text += std::to_string(value) + " ";
    }
    for (std::size_t key = 0; key < kCameraKeys; ++key) {
        text += input.keys.has(static_cast<CameraKey>(key)) ? '1' : '0';
    }
    for (const bool flag : {step.orbits, step.zooms, step.minimises, step.screenshot, step.returnsHome,
                            step.click.has_value(), step.resize.has_value()}) {
        text += flag ? '1' : '0';
    }
    return text + (step.settings ? nameOf(step.settings->technique) + step.settings->scene : "");
}

TEST(SoakInput, IsTheSameForTheSameSeed) {
    SoakInput a({.seed = 4});
    SoakInput b({.seed = 4});
    SoakInput c({.seed = 5});
    bool differs = false;
    for (int i = 0; i < 3000; ++i) {
        const std::string step = textOf(a.next());
        ASSERT_EQ(step, textOf(b.next()));
        differs = differs || step != textOf(c.next());
    }
    EXPECT_TRUE(differs);
}

TEST(SoakInput, IsBoundedAndReachesEverything) {
    SoakInput soak;
    std::set<std::string> seen;
    PictureExtent extent;
    for (int i = 0; i < kSteps; ++i) {
        const SoakStep step = soak.next();
        const CameraInput& input = step.input;
        if (step.resize) {
            extent = *step.resize;
            seen.insert(extent.width < 10 ? "narrow" : extent.width > 1000 ? "wide" : "");
        }
        ASSERT_EQ(input.extent, extent);
        ASSERT_GE(extent.width, 1u);
        ASSERT_LE(extent.width, kSoakLargest.width);
        ASSERT_GE(extent.height, 1u);
        ASSERT_LE(extent.height, kSoakLargest.height);
        ASSERT_LE(glm::length(input.drag), 2300.0);
        ASSERT_LE(std::abs(input.scroll), 3.0);
        ASSERT_TRUE(input.cursor.x >= 0.0 && input.cursor.x <= extent.width);
        ASSERT_TRUE(input.cursor.y >= 0.0 && input.cursor.y <= extent.height);
        if (step.click) {
            ASSERT_LT(step.click->x, extent.width);
            ASSERT_LT(step.click->y, extent.height);
            seen.insert("click");
        }
        for (const auto& [happens, what] :
             {std::pair(step.orbits, "orbit"), std::pair(step.zooms, "zoom"),
              std::pair(step.minimises, "minimise"), std::pair(step.screenshot, "screenshot"),
              std::pair(step.returnsHome, "home"), std::pair(input.pan != glm::dvec2(0.0), "pan")}) {
            seen.insert(happens ? what : "");
        }
        for (std::size_t key = 0; key < kCameraKeys; ++key) {
            seen.insert(input.keys.has(static_cast<CameraKey>(key)) ? "key " + std::to_string(key) : "");
        }
        if (step.settings) {
            const ViewSettings& s = *step.settings;
            ASSERT_GE(s.drawing.threads, 1u);
            ASSERT_LE(s.drawing.threads, 4u);
            ASSERT_TRUE(s.divider >= 0.0 && s.divider <= 1.0);
            depth::parseSplit(depth::nameOf(s.technique.split));
            seen.insert("scene " + s.scene);
            seen.insert("view " + std::string(nameOf(s.view)));
            seen.insert("targets " + render::nameOf(s.drawing.targets));
            seen.insert("mapping " + std::string(depth::nameOf(s.technique.mapping)));
            seen.insert("format " + std::string(depth::nameOf(s.technique.format)));
            seen.insert("submission " + std::string(render::nameOf(s.drawing.submission)));
            seen.insert("batching " + std::string(render::nameOf(s.drawing.batching)));
            seen.insert("snapping " + std::string(render::nameOf(s.drawing.snapping)));
            const render::Effects& effects = s.drawing.effects;
            seen.insert(effects.antialias == render::Antialias::edges ? "smooth edges" : "");
            seen.insert(effects.occlusion.radius > 0.0 ? "occlusion" : "");
            seen.insert(effects.fog.visibility > 0.0 ? "fog" : "");
            seen.insert(s.drawing.focus.isOn() ? "focus" : "");
            seen.insert(s.drawing.translucency.method == render::Translucency::sorted ? "sorted" : "");
            render::requireUsable(effects);
            render::requireUsable(s.drawing.focus);
            seen.insert(s.second ? "split screen" : "one picture");
        }
    }
    seen.erase("");
    // 9 events, keys, 2 screens, 5 ways to finish, and the scenes, views, targets, mappings, formats,
    // submissions, batchings and snappings.
    EXPECT_EQ(seen.size(), 9u + kCameraKeys + 2u + 5u + 4u + 6u + 5u + 6u + 3u + 3u + 3u + 2u) << [&] {
        std::string all;
        for (const std::string& what : seen) {
            all += what + "; ";
        }
        return all;
    }();
}

TEST(SoakInput, KeepsToTheLargestWindowItIsGiven) {
    SoakInput soak({.largest = {160, 90}});
    std::uint32_t widest = 0;
    for (int i = 0; i < kSteps / 4; ++i) {
        const std::optional<PictureExtent> resize = soak.next().resize;
        if (resize) {
            ASSERT_LE(resize->width, 160u);
            ASSERT_LE(resize->height, 90u);
            widest = std::max(widest, resize->width);
        }
    }
    EXPECT_GT(widest, 80u);
}

/// A camera that returns home now and then stays usable under any input. The soak is for this.
TEST(SoakInput, LeavesEveryCameraUsable) {
    const scene::Camera home =
        scene::lookAt({.fovY = 1.0, .nearView = 0.1, .farView = 1e5}, {0.0, 2.0, 50.0}, glm::dvec3(0.0));
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        SoakInput soak({.seed = seed});
        Orbit state{.camera = home, .pivot = glm::dvec3(0.0)};
        for (int i = 0; i < kSteps / 4; ++i) {
            const SoakStep step = soak.next();
            CameraInput input = step.input;
            if (step.returnsHome) {
                state = {.camera = home, .pivot = glm::dvec3(0.0)};
            }
            if (step.zooms) {
                input.lens = std::exchange(input.scroll, 0.0);
                state.camera = zoomLens(state.camera, input);
            }
            if (step.orbits) {
                state = orbit(state, input);
            } else {
                const double surface = glm::distance(state.camera.position, state.pivot);
                state.camera = fly(state.camera, input, flightDistance(state.camera, surface, 1.0));
            }
            ASSERT_NO_THROW(scene::requireUsable(state.camera)) << seed << " " << i;
            ASSERT_NEAR(glm::length(state.camera.back), 1.0, 1e-12);
            ASSERT_NEAR(glm::dot(state.camera.right, state.camera.back), 0.0, 1e-12);
            ASSERT_GE(state.camera.fovY, scene::radiansOf(kNarrowestDegrees));
            ASSERT_LE(state.camera.fovY, scene::radiansOf(kWidestDegrees));
        }
    }
}

} // namespace

} // namespace cdr::viewer
