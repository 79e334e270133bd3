#include "../support/refusal.h"
#include "../support/shared_device.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <experiments/flicker/flicker.h>
#include <experiments/flicker/pairs.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <program/sha256.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

namespace {

namespace fs = std::filesystem;
using namespace cdr;
using namespace cdr::experiments;

class FlickerTest : public cdr::test::DeviceTest {
  protected:
    fs::path state() const { return m_folder.path() / "state.json"; }

  private:
    cdr::test::TemporaryFolder m_folder;
};

FlickerOptions smallRun() {
    FlickerOptions options;
    options.width = 320;
    options.height = 180;
    options.frames = 6;
    options.techniques = {depth::namedTechnique("log"), depth::namedTechnique("anchored")};
    return options;
}

/// All that a result holds.
auto figures(const FlickerResult& r) {
    return std::tuple(r.scene, r.technique, r.format, r.frames, r.wrong.pixels, r.wrong.wrong,
                      r.wrong.edgeWrong, r.wrong.overlapPixels, r.wrong.overlapWrong, r.flips.flips,
                      r.flips.compared, r.flipSum, r.flipFrames, r.duplicationSum, r.cascades);
}

void expectSame(const std::vector<FlickerResult>& a, const std::vector<FlickerResult>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(figures(a[i]), figures(b[i])) << a[i].technique;
    }
}

struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Hooks that note a hash of every picture, and fail before step `last` of the run.
struct Watcher {
    std::size_t last = 1000;
    std::map<std::uint32_t, std::vector<std::string>> pictures{};

    FlickerHooks hooks() {
        return {.progress =
                    [this](std::size_t done, std::size_t, const std::string&) {
                        if (done == last) {
                            throw Interrupted("here");
                        }
                    },
                .pictures =
                    [this](std::uint32_t frame, const std::vector<image::ImageRgba8>& shown) {
                        for (const image::ImageRgba8& picture : shown) {
                            pictures[frame].push_back(program::sha256Of(picture.pixels));
                        }
                    }};
    }
};

/// Interrupted twice, once between two techniques of a frame: the same figures, the same pictures.
TEST_F(FlickerTest, ARunThatIsInterruptedEndsAsOneThatIsNot) {
    FlickerOptions options = smallRun();
    Watcher whole;
    const auto expected = runFlicker(device(), options, whole.hooks());
    EXPECT_GT(expected[0].flips.compared, 0u);
    EXPECT_GT(expected[0].flipSum, 0.0);

    options.state = state();
    for (const std::size_t step : {std::size_t{5}, std::size_t{8}}) {
        Watcher cut{.last = step};
        EXPECT_THROW(runFlicker(device(), options, cut.hooks()), Interrupted);
        EXPECT_TRUE(fs::exists(state()));
    }
    Watcher rest;
    expectSame(runFlicker(device(), options, rest.hooks()), expected);
    EXPECT_EQ(rest.pictures, whole.pictures);
    // A finished run gives the same results again, also without pictures.
    expectSame(runFlicker(device(), options), expected);
}

/// Another run by its figures and by its state.
TEST_F(FlickerTest, RoundedVerticesAreAnotherRun) {
    if (device().info().subPixelBits <= 4) {
        GTEST_SKIP() << "the device itself rounds vertices to so few bits";
    }
    FlickerOptions options = smallRun();
    options.frames = 1;
    options.techniques = {depth::namedTechnique("anchored")};
    options.state = state();
    const FlickerResult exact = runFlicker(device(), options).at(0);
    options.snapBits = 2;
    EXPECT_THROW(runFlicker(device(), options), base::InputError);
    options.state.reset();
    EXPECT_GT(runFlicker(device(), options).at(0).wrong.edgeWrong, exact.wrong.edgeWrong);
}

/// A fitted split remembers frames, and a coarse buffer shows where it cut. The frame before is not enough: its
/// bounds are kept from still earlier frames.
TEST_F(FlickerTest, AResumedRunRemembersWhatFittedSplitsDo) {
    FlickerOptions options = smallRun();
    options.width = 640;
    options.height = 360;
    options.frames = 24;
    options.nearObject = true;
    options.techniques = {{"standard-fitted",
                           {.mapping = depth::Mapping::standard,
                            .split = depth::SplitFitted{.most = 2},
                            .format = depth::DepthFormat::d16}}};
    const auto expected = runFlicker(device(), options);
    EXPECT_GT(expected[0].wrong.wrong, 0u);
    options.state = state();
    for (const std::size_t step : {std::size_t{4}, std::size_t{9}, std::size_t{17}}) {
        Watcher cut{.last = step};
        EXPECT_THROW(runFlicker(device(), options, {.progress = cut.hooks().progress, .pictures = {}}),
                     Interrupted);
    }
    expectSame(runFlicker(device(), options), expected);
}

TEST_F(FlickerTest, AStateOfAnotherRunIsRefused) {
    FlickerOptions options = smallRun();
    options.frames = 1;
    options.state = state();
    runFlicker(device(), options);
    const auto refused = [&](const FlickerOptions& other) {
        const std::string said = cdr::test::inputErrorOf([&] { runFlicker(device(), other); });
        return said.find("other options, another version or device") != std::string::npos &&
               said.find('\n') == std::string::npos;
    };
    const auto with = [&](auto change) {
        FlickerOptions other = options;
        change(other);
        return other;
    };
    EXPECT_TRUE(refused(with([](auto& o) { o.frames = 2; })));
    EXPECT_TRUE(refused(with([](auto& o) { o.seed = 1; })));
    EXPECT_TRUE(refused(with([](auto& o) { o.width = 322; })));
    EXPECT_TRUE(refused(with([](auto& o) { o.nearObject = true; })));
    EXPECT_TRUE(refused(with([](auto& o) { o.techniques.pop_back(); })));
    EXPECT_TRUE(refused(with([](auto& o) { o.rivalsBeside = {rivals::parseRival("atomic-log")}; })));
    EXPECT_TRUE(refused(with([](auto& o) { o.techniques[0].technique.format = depth::DepthFormat::d16; })));
    EXPECT_FALSE(refused(with([](auto& o) { o.threads = 2; }))); // which changes nothing
}

TEST_F(FlickerTest, ADamagedStateIsRefused) {
    FlickerOptions options = smallRun();
    options.frames = 1;
    options.state = state();
    runFlicker(device(), options);
    const platform::Bytes whole = platform::readFile(state(), 1 << 20);
    const std::string text(whole.begin(), whole.end());
    for (const std::string& damaged : {text.substr(0, text.size() / 2), std::string("[]"), std::string(),
                                       std::string(2 << 20, ' '), std::string("{\"digest\": 3}")}) {
        platform::writeText(state(), damaged);
        EXPECT_THROW(runFlicker(device(), options), base::InputError) << damaged.substr(0, 40);
    }
}

/// Numbers that the run cannot have come to; else any would be averaged in. They are refused as such, before the sum of the state
/// is compared. No frame bounds the sum of duplications.
TEST_F(FlickerTest, AlteredCountsAreRefused) {
    FlickerOptions options = smallRun();
    options.frames = 2;
    options.state = state();
    runFlicker(device(), options);
    const platform::Bytes whole = platform::readFile(state(), 1 << 20);
    const auto json = nlohmann::json::parse(whole);
    for (const auto& [name, value] : json.at("results").at(0).items()) {
        if (value.is_string()) {
            continue;
        }
        for (const char* wrong : {"-1", "1e300", "18446744073709551615", "\"1\"", "-0.5"}) {
            nlohmann::json altered = json;
            altered["results"][0][name] = nlohmann::json::parse(wrong);
            platform::writeText(state(), altered.dump());
            const std::string said = cdr::test::inputErrorOf([&] { runFlicker(device(), options); });
            EXPECT_NE(said, "") << name << " " << wrong;
            const nlohmann::json& now = altered["results"][0][name];
            const bool hasNoBound = name == "duplication_sum" && now.is_number() && now.get<double>() > 0.0;
            EXPECT_EQ(said.find("is damaged") != std::string::npos, hasNoBound) << name << ": " << said;
        }
    }
    platform::writeText(state(), std::string(whole.begin(), whole.end()));
    EXPECT_NO_THROW(runFlicker(device(), options));
}

TEST_F(FlickerTest, ThreadsDoNotChangeTheFigures) {
    FlickerOptions options = smallRun();
    options.frames = 2;
    const auto one = runFlicker(device(), options);
    options.threads = 3;
    expectSame(runFlicker(device(), options), one);
}

/// The field straddles cdr's boundary: the half in front of it is as bad as standard. Cut in front of the
/// field nearly all is right, cut behind it nearly all is as bad.
TEST_F(FlickerTest, MovingTheBoundaryDecidesAboutCdr) {
    FlickerOptions options = smallRun();
    options.frames = 4;
    options.techniques = movedBoundaries();
    options.techniques.push_back(depth::namedTechnique("cdr"));
    const auto results = runFlicker(device(), options);
    EXPECT_EQ(results[0].technique, "cdr-before");
    EXPECT_LT(results[0].wrong.fraction(), 0.2 * results[2].wrong.fraction().value());
    EXPECT_GT(results[1].wrong.fraction(), 1.5 * results[2].wrong.fraction().value());
}

/// Fitting near and far to the field helps until something is beside the camera; fitting cascades still does.
TEST_F(FlickerTest, ANearObjectDisturbsAFittedRangeAndNotFittedCascades) {
    FlickerOptions options = smallRun();
    options.frames = 4;
    options.techniques = {fittedRange(), depth::namedTechnique("anchored")};
    const auto without = runFlicker(device(), options);
    options.nearObject = true;
    const auto with = runFlicker(device(), options);
    EXPECT_EQ(without[0].scene, "afc");
    EXPECT_EQ(with[0].scene, "afc-near");
    EXPECT_LT(without[0].wrong.fraction(), 0.005);
    EXPECT_GT(with[0].wrong.fraction(), 0.1);
    EXPECT_LT(with[1].wrong.fraction(), 0.0001);
    EXPECT_GE(with[1].cascades, 2u);
}

TEST_F(FlickerTest, RivalsHaveFiguresAndNoPictures) {
    if (!device().info().hasInt64Atomics || !device().info().hasFragmentStores) {
        leaveOut("64-bit atomics");
        return;
    }
    FlickerOptions options = smallRun();
    options.frames = 2;
    const auto without = runFlicker(device(), options);
    options.rivalsBeside = {rivals::parseRival("object-anchors")};
    Watcher watcher;
    auto with = runFlicker(device(), options, watcher.hooks());
    ASSERT_EQ(with.size(), 3u);
    const FlickerResult rival = with.back();
    EXPECT_TRUE(rival.isRival());
    EXPECT_EQ(rival.flipFrames, 0u);
    EXPECT_EQ(rival.wrong.pixels, with.front().wrong.pixels);
    EXPECT_EQ(rival.wrong.wrong, with[1].wrong.wrong); // as anchored
    EXPECT_EQ(rival.duplication(), 1.0);
    for (const auto& [frame, pictures] : watcher.pictures) {
        EXPECT_EQ(pictures.size(), 2u) << frame;
    }
    with.pop_back();
    expectSame(with, without);
}

FlickerResult resultOf(const std::string& technique, std::uint64_t flips) {
    FlickerResult result;
    result.technique = technique;
    result.flips = {.flips = flips, .compared = 1000};
    return result;
}

TEST(FlickerPairs, TheObserverTakesTheSideWithFewerFlips) {
    const auto pairs = comparePairs({resultOf("logcdr", 9), resultOf("cdr", 50), resultOf("log", 9),
                                     resultOf("standard", 40), resultOf("anchored", 0)});
    ASSERT_EQ(pairs.size(), 6u);
    EXPECT_EQ(pairs[0].left, "standard");
    EXPECT_EQ(pairs[0].right, "cdr");
    EXPECT_EQ(pairs[0].observer, Side::left); // against the people, and it says so
    EXPECT_FALSE(pairs[0].agree());
    EXPECT_EQ(pairs[1].observer, Side::right);
    EXPECT_TRUE(pairs[1].agree());
    EXPECT_EQ(pairs[5].observer, std::nullopt); // as many on both sides
    EXPECT_FALSE(pairs[5].agree());
    EXPECT_EQ(comparePairs({resultOf("cdr", 1), resultOf("log", 1), resultOf("reversed", 0)}).size(), 1u);
}

TEST(FlickerPairs, WithoutPixelsThatCouldFlipThereIsNoVerdict) {
    FlickerResult none = resultOf("cdr", 0);
    none.flips.compared = 0;
    const auto pairs = comparePairs({none, resultOf("log", 0), resultOf("standard", 1)});
    ASSERT_EQ(pairs.size(), 3u);
    EXPECT_FALSE(pairs[0].couldJudge()) << pairs[0].left << " " << pairs[0].right;
    EXPECT_EQ(pairs[0].observer, std::nullopt);
    EXPECT_TRUE(pairs[2].couldJudge()) << pairs[2].left << " " << pairs[2].right;
}

/// The pairs add up to Table 6.2.
TEST(FlickerPairs, CountsAddUpToTheThesisTotals) {
    std::map<std::string_view, unsigned> chosen;
    for (const ThesisPair& pair : kThesisPairs) {
        chosen[pair.left] += pair.humans.left;
        chosen[pair.right] += pair.humans.right;
        EXPECT_EQ(pair.humans.all(), 12u);
    }
    EXPECT_EQ(chosen, (std::map<std::string_view, unsigned>{
                          {"standard", 2}, {"cdr", 10}, {"log", 25}, {"logcdr", 35}}));
}

} // namespace
