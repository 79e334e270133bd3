#include "../support/shared_device.h"

#include <experiments/probe/probe.h>

#include <gtest/gtest.h>
#include <ranks/one_process.h>

#include <cstdio>

namespace {

using namespace cdr;
using namespace cdr::experiments;

using Probe = cdr::test::DeviceTest;

/// What the thesis missed (chapter 7): a prediction that holds in practice. Within a factor of four wherever
/// a rung of the ladder is resolved, and above the ladder's widest rung where none is.
TEST_F(Probe, PredictionsHoldOverTechniquesFormatsAndDistances) {
    ProbeOptions options;
    options.distancesView = {10.0, 1e6};
    options.drawing.threads = 2;
    std::size_t resolved = 0;
    ranks::OneProcess alone;
    for (const ProbeResult& row : runProbe(
             device(), options, [](auto, auto, const auto&) {}, alone)) {
        const std::string name = row.technique + " " + std::string(nameOf(row.format.value())) + " at " +
                                 std::to_string(row.distanceView);
        if (!row.resolvedView) {
            EXPECT_GT(row.predictedView, row.largestView / 4.0) << name;
            continue;
        }
        ++resolved;
        const double ratio = *row.resolvedView / row.predictedView;
        std::printf("%s: measured %.3g, predicted %.3g, ratio %.2f\n", name.c_str(), *row.resolvedView,
                    row.predictedView, ratio);
        EXPECT_LT(ratio, 4.0) << name;
        EXPECT_GT(ratio, 0.25) << name;
        // The probe counts pixels whose gap is half the separation, so twice the guarantee is what it must
        // resolve.
        EXPECT_LE(*row.resolvedView, 2.0 * row.guaranteedView) << name;
    }
    EXPECT_GE(resolved, 5 * available(depth::kDepthFormats).size());
}

/// As graphics cards with few sub-pixel bits draw: the gaps that they resolve are larger.
TEST_F(Probe, RoundedVerticesResolveLess) {
    if (device().info().subPixelBits <= 4) {
        GTEST_SKIP() << "the device itself rounds vertices to so few bits";
    }
    ProbeOptions options;
    options.distancesView = {1000.0};
    options.techniques = {depth::namedTechnique("anchored")};
    options.formats = {depth::DepthFormat::d32f};
    options.drawing.width = 640;
    options.drawing.height = 360;
    ranks::OneProcess alone;
    const auto resolved = [&](std::uint32_t snapBits) {
        options.drawing.snapBits = snapBits;
        return runProbe(
                   device(), options, [](auto, auto, const auto&) {}, alone)
            .at(0)
            .resolvedView.value();
    };
    if (device().info().kind == gpu::DeviceKind::cpu) {
        EXPECT_GT(resolved(4), resolved(0));
    } else { // a graphics card rounds by itself, and the ladder is coarse
        EXPECT_GE(resolved(4), resolved(0));
    }
}

/// Cubes so small in the picture that no pixel shows a pair off edges.
TEST_F(Probe, APictureTooSmallToTellSaysNothing) {
    ProbeOptions options;
    options.distancesView = {1000.0};
    options.techniques = {depth::namedTechnique("anchored")};
    options.formats = {depth::DepthFormat::d32f};
    ranks::OneProcess alone;
    const auto measured = [&](std::uint32_t width, std::uint32_t height) {
        options.drawing.width = width;
        options.drawing.height = height;
        return runProbe(
                   device(), options, [](auto, auto, const auto&) {}, alone)
            .at(0);
    };
    EXPECT_EQ(measured(64, 36).pairsSeen, 0u);
    EXPECT_FALSE(measured(64, 36).resolvedView);
    EXPECT_GT(measured(320, 180).pairsSeen, 10u);
    EXPECT_TRUE(measured(320, 180).resolvedView);
}

} // namespace
