#include <viewer/state/explanations.h>
#include <viewer/state/view_settings.h>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

namespace cdr::viewer {

namespace {

TEST(ViewSettings, PresetKeysKeepTheFormatAndTheOtherSide) {
    ViewSettings settings;
    settings.technique.format = depth::DepthFormat::d24;
    settings.second = presetOfKey(2);
    const ViewSettings left = withPreset(settings, 0, 1);
    EXPECT_EQ(nameOf(left.technique), "standard");
    EXPECT_EQ(left.technique.format, depth::DepthFormat::d24);
    EXPECT_EQ(left.second, settings.second);
    const ViewSettings right = withPreset(settings, 1, kPresetKeys);
    EXPECT_EQ(nameOf(*right.second), "anchored");
    EXPECT_EQ(right.technique, settings.technique);
    settings.second.reset(); // without a right side, keys change the only one
    EXPECT_EQ(nameOf(withPreset(settings, 1, 4).technique), "logcdr");
    for (std::size_t key = 1; key <= kPresetKeys; ++key) {
        EXPECT_EQ(nameOf(presetOfKey(key)), depth::presets()[key - 1].name);
    }
}

TEST(ViewSettings, TheRightSideBeginsInTheFormatOfTheLeft) {
    ViewSettings settings;
    settings.technique.format = depth::DepthFormat::d16;
    compareTwo(settings, true);
    ASSERT_TRUE(settings.second.has_value());
    EXPECT_EQ(nameOf(*settings.second), "anchored");
    EXPECT_EQ(settings.second->format, depth::DepthFormat::d16);
    compareTwo(settings, false);
    EXPECT_FALSE(settings.second.has_value());
}

/// A file's own lights may be missing in the next, and generated scenes have none to choose.
TEST(ViewSettings, AnotherFileKeepsALampOrASky) {
    ViewSettings settings;
    settings.choice.light = scene::ModelLight::lamps;
    chooseScene(settings, "a.glb");
    EXPECT_EQ(settings.choice.light, scene::ModelLight::lamps);
    chooseScene(settings, "cubes");
    EXPECT_FALSE(settings.choice.light.has_value());
    settings.choice.light = scene::ModelLight::file;
    chooseScene(settings, "a.glb");
    EXPECT_FALSE(settings.choice.light.has_value());
}

TEST(ViewSettings, ShadowsAreDrawnWhereLevelsOfDetailAndFocusLeaveThem) {
    using visibility::DetailMode;
    for (const render::ShadowMethod method : {render::ShadowMethod::anchored, render::ShadowMethod::plain}) {
        render::RenderOptions options;
        EXPECT_FALSE(castsShadows(options)) << "none are chosen";
        options.shadows.method = method;
        for (const DetailMode mode : visibility::kDetailModes) {
            options.detail.mode = mode;
            EXPECT_EQ(castsShadows(options), mode == DetailMode::none || mode == DetailMode::perObject);
        }
        options.detail.mode = DetailMode::none;
        options.focus = {.distance = 3.0, .aperture = 0.1};
        EXPECT_TRUE(castsShadows(options)) << "a focus is for layers";
        options.targets = render::TargetsKind::layers;
        EXPECT_FALSE(castsShadows(options));
        EXPECT_NE(explanationOf(method).find("nor with levels of detail by cascade or cluster"),
                  std::string_view::npos);
    }
}

TEST(ViewSettings, SidesBecomeRenderOptions) {
    ViewSettings settings;
    settings.second = presetOfKey(3);
    settings.drawing.threads = 3;
    settings.drawing.targets = render::TargetsKind::layers;
    const render::RenderOptions left = renderOptions(settings, 0, {640, 360});
    const render::RenderOptions right = renderOptions(settings, 1, {640, 360});
    EXPECT_EQ(nameOf(left.technique), "anchored");
    EXPECT_EQ(nameOf(right.technique), "log");
    EXPECT_EQ(right.width, 640u);
    EXPECT_EQ(right.threads, 3u);
    EXPECT_EQ(right.targets, render::TargetsChoice(render::TargetsKind::layers));
}

/// They are of the machine and of who looks, and not of a scene.
TEST(ViewSettings, AnotherSceneKeepsWhatBoundsTexturesAndPoints) {
    ViewSettings settings;
    settings.choice.camera = 1;
    settings.choice.textureMiB = 64;
    settings.choice.pointRadius = 0.1;
    chooseScene(settings, "other.glb");
    EXPECT_FALSE(settings.choice.camera);
    EXPECT_EQ(settings.choice.textureMiB, 64u);
    EXPECT_EQ(settings.choice.pointRadius, 0.1);
}

/// A file may have changed since; a generated scene does not.
TEST(ViewSettings, ChoosingTheSameFileAgainIsAnotherRequest) {
    ViewSettings settings;
    chooseScene(settings, "a.glb");
    const ViewSettings first = settings;
    chooseScene(settings, "a.glb");
    EXPECT_NE(settings, first);
    chooseScene(settings, "cubes");
    const ViewSettings cubes = settings;
    chooseScene(settings, "cubes");
    EXPECT_EQ(settings, cubes);
}

/// A request may fail long after it was asked.
TEST(ViewSettings, AFailureLeavesWhatWasChosenSince) {
    ViewSettings good;
    good.divider = 0.1;
    ViewSettings failed = good;
    chooseScene(failed, "missing.glb");
    ViewSettings now = failed;
    now.divider = 0.3; // pictures do not depend on it
    const ViewSettings mended = settingsAfterFailure(now, failed, good);
    EXPECT_EQ(mended.scene, good.scene);
    EXPECT_EQ(mended.divider, 0.3);
    chooseScene(now, "cubes");
    EXPECT_EQ(settingsAfterFailure(now, failed, good), now);
}

TEST(Explanations, EachChoiceHasASentenceOfItsOwn) {
    std::set<std::string> seen;
    const auto expectSentence = [&](std::string_view text) {
        EXPECT_GE(text.size(), 50u) << text;
        EXPECT_LE(text.size(), 300u) << text;
        EXPECT_TRUE(text.ends_with('.')) << text;
        EXPECT_TRUE(seen.insert(std::string(text)).second) << text;
    };
    for (const depth::Mapping mapping : depth::kMappings) {
        expectSentence(explanationOf(mapping));
    }
    for (const char* split : {"none", "ratio:10", "count:3", "at:1,2", "fitted", "minimax:2"}) {
        expectSentence(explanationOf(depth::parseSplit(split)));
    }
    for (const depth::DepthFormat format : depth::kDepthFormats) {
        expectSentence(explanationOf(format));
    }
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        expectSentence(explanationOf(targets));
    }
    for (const render::Submission submission : render::kSubmissions) {
        expectSentence(explanationOf(submission));
    }
    for (const render::Batching batching : render::kBatchings) {
        expectSentence(explanationOf(batching));
    }
    for (const render::Snapping snapping : render::kSnappings) {
        expectSentence(explanationOf(snapping));
    }
    for (const ViewKind view : kViewKinds) {
        expectSentence(explanationOf(view));
    }
    expectSentence(explainThreads());
}

} // namespace

} // namespace cdr::viewer
