#include "../support/shared_device.h"
#include "../support/temporary_folder.h"

#include <experiments/flicker/flicker.h>
#include <experiments/flicker/pairs.h>

#include <gtest/gtest.h>
#include <ranks/one_process.h>
#include <runs/kept_ranks.h>

#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

namespace {

using namespace cdr;
using namespace cdr::experiments;

const NamedProgress kNoProgress = [](std::size_t, std::size_t, const std::string&) {};

class FlickerTest : public cdr::test::DeviceTest {
  protected:
    std::vector<FlickerResult> run(const FlickerOptions& options) {
        return runFlicker(device(), options, kNoProgress, m_alone);
    }

    /// A start of a run that keeps its results.
    std::vector<FlickerResult> startKept(const FlickerOptions& options,
                                         const NamedProgress& progress = kNoProgress) const {
        ranks::OneProcess alone;
        runs::KeptRanks kept(alone, m_folder.path() / "s", "run");
        return runFlicker(device(), options, progress, kept);
    }

    ranks::OneProcess m_alone;

  private:
    cdr::test::TemporaryFolder m_folder;
};

FlickerOptions smallRun() {
    FlickerOptions options;
    options.drawing.width = 320;
    options.drawing.height = 180;
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

NamedProgress interruptedAt(std::size_t step) {
    return [step](std::size_t done, std::size_t, const std::string&) {
        if (done == step) {
            throw Interrupted("here");
        }
    };
}

/// Interrupted twice, once between two techniques of a frame.
TEST_F(FlickerTest, ARunThatIsInterruptedEndsAsOneThatIsNot) {
    const FlickerOptions options = smallRun();
    const auto expected = run(options);
    EXPECT_GT(expected[0].flips.compared, 0u);
    EXPECT_GT(expected[0].flipSum, 0.0);
    for (const std::size_t step : {std::size_t{5}, std::size_t{8}}) {
        EXPECT_THROW(startKept(options, interruptedAt(step)), Interrupted);
    }
    // It goes on behind what is kept, and then has nothing to make.
    expectSame(startKept(options, interruptedAt(1)), expected);
    expectSame(startKept(options, interruptedAt(11)), expected);
}

TEST_F(FlickerTest, RoundedVerticesAreWrongAtMoreEdges) {
    if (device().info().subPixelBits <= 4) {
        GTEST_SKIP() << "the device itself rounds vertices to so few bits";
    }
    FlickerOptions options = smallRun();
    options.frames = 1;
    options.techniques = {depth::namedTechnique("anchored")};
    const FlickerResult exact = run(options).at(0);
    options.drawing.snapBits = 2;
    EXPECT_GT(run(options).at(0).wrong.edgeWrong, exact.wrong.edgeWrong);
}

/// A fitted split remembers frames, and a coarse buffer shows where it cut. The frame before is not enough: its
/// bounds are kept from still earlier frames.
TEST_F(FlickerTest, AResumedRunRemembersWhatFittedSplitsDo) {
    FlickerOptions options = smallRun();
    options.drawing.width = 640;
    options.drawing.height = 360;
    options.frames = 24;
    options.nearObject = true;
    options.techniques = {{"standard-fitted",
                           {.mapping = depth::Mapping::standard,
                            .split = depth::SplitFitted{.most = 2},
                            .format = depth::DepthFormat::d16}}};
    const auto expected = run(options);
    EXPECT_GT(expected[0].wrong.wrong, 0u);
    for (const std::size_t step : {std::size_t{4}, std::size_t{9}, std::size_t{17}}) {
        EXPECT_THROW(startKept(options, interruptedAt(step)), Interrupted);
    }
    expectSame(startKept(options), expected);
}

TEST_F(FlickerTest, ThreadsDoNotChangeTheFigures) {
    FlickerOptions options = smallRun();
    options.frames = 2;
    const auto one = run(options);
    options.drawing.threads = 3;
    expectSame(run(options), one);
}

/// The field straddles cdr's boundary: the half in front of it is as bad as standard. Cut in front of the
/// field nearly all is right, cut behind it nearly all is as bad.
TEST_F(FlickerTest, MovingTheBoundaryDecidesAboutCdr) {
    FlickerOptions options = smallRun();
    options.frames = 4;
    options.techniques = movedBoundaries();
    options.techniques.push_back(depth::namedTechnique("cdr"));
    const auto results = run(options);
    EXPECT_EQ(results[0].technique, "cdr-before");
    EXPECT_LT(results[0].wrong.fraction(), 0.2 * results[2].wrong.fraction().value());
    EXPECT_GT(results[1].wrong.fraction(), 1.5 * results[2].wrong.fraction().value());
}

/// Fitting near and far to the field helps until something is beside the camera; fitting cascades still does.
TEST_F(FlickerTest, ANearObjectDisturbsAFittedRangeAndNotFittedCascades) {
    FlickerOptions options = smallRun();
    options.frames = 4;
    options.techniques = {fittedRange(), depth::namedTechnique("anchored")};
    const auto without = run(options);
    options.nearObject = true;
    const auto with = run(options);
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
    const auto without = run(options);
    options.rivalsBeside = {rivals::parseRival("object-anchors")};
    auto with = run(options);
    ASSERT_EQ(with.size(), 3u);
    const FlickerResult rival = with.back();
    EXPECT_TRUE(rival.isRival());
    EXPECT_EQ(rival.flipFrames, 0u);
    EXPECT_EQ(rival.wrong.pixels, with.front().wrong.pixels);
    EXPECT_EQ(rival.wrong.wrong, with[1].wrong.wrong); // as anchored
    EXPECT_EQ(rival.duplication(), 1.0);
    with.pop_back();
    expectSame(with, without);
    std::uint32_t next = 0;
    showFlicker(device(), options, kNoProgress, m_alone,
                [&](std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures) {
                    EXPECT_EQ(frame, next++);
                    EXPECT_EQ(pictures.size(), 2u);
                });
    EXPECT_EQ(next, options.frames);
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
