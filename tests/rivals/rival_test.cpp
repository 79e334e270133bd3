#include "../support/refusal.h"

#include <cdr/base/error.h>

#include <gtest/gtest.h>
#include <rivals/key_scale.h>
#include <rivals/rival.h>

#include <bit>
#include <cmath>

namespace {

using namespace cdr;
using namespace cdr::rivals;

TEST(Rivals, ANameWithAPrepassIsTheSameRivalBehindOne) {
    for (const NamedRival& known : namedRivals()) {
        EXPECT_EQ(parseRival(known.name).rival, known.rival);
        const NamedRival behind = parseRival(known.name + "/prepass");
        EXPECT_TRUE(behind.rival.prepass);
        EXPECT_EQ(behind.rival.distance, known.rival.distance);
        EXPECT_EQ(behind.rival.key, known.rival.key);
        EXPECT_EQ(geometryPassesOf(behind.rival), geometryPassesOf(known.rival) + 1);
        EXPECT_EQ(bytesPerPixelOf(behind.rival), bytesPerPixelOf(known.rival) + 4);
    }
}

TEST(Rivals, AnUnknownNameIsRefusedWithASuggestion) {
    const std::string refusal = test::inputErrorOf([] { parseRival("object-anchor"); }, "taken");
    EXPECT_NE(refusal.find("object-anchors"), std::string::npos) << refusal;
    EXPECT_THROW(parseRival("/prepass"), base::InputError);
}

TEST(Rivals, WhatADeviceLacksIsNamed) {
    gpu::DeviceInfo device;
    const Rival fixed = parseRival("atomic-fixed").rival;
    const Rival pairs = parseRival("object-anchors").rival;
    EXPECT_EQ(missingFeatures(device, fixed), featuresOf(fixed));
    device.hasFragmentStores = true;
    device.hasInt64Atomics = true;
    EXPECT_EQ(missingFeatures(device, fixed), std::vector<std::string>{"shaderFloat64"});
    EXPECT_TRUE(missingFeatures(device, pairs).empty());
    const Rival sieved = parseRival("object-anchors/prepass").rival;
    EXPECT_EQ(missingFeatures(device, sieved), std::vector<std::string>{"depth buffers of 32 bits"});
    device.depthFormats = {depth::DepthFormat::d32f};
    EXPECT_TRUE(missingFeatures(device, sieved).empty());
}

/// As shaders/rivals/key.glsl makes keys of an exact distance.
std::uint64_t logKeyOf(double distanceView, const shaders::RivalPush& push) {
    const std::uint64_t origin = std::uint64_t{push.originTop} << 32u;
    return ((std::bit_cast<std::uint64_t>(distanceView) - origin) >> push.shift) << shaders::kIdBits;
}

TEST(Rivals, LogKeysFillTheirFortyBitsAndComeBackWithinAStep) {
    for (const auto& [nearView, farView] : {std::pair{0.001, 2e6}, {0.1, 2e8}, {1.0, 2.0}, {1e-6, 1e12}}) {
        scene::Camera camera;
        camera.nearView = nearView;
        camera.farView = farView;
        const KeyScale scale(parseRival("atomic-log-object").rival, camera);
        const shaders::RivalPush push = scale.pushFor(1);
        const std::uint64_t last = logKeyOf(farView, push);
        EXPECT_LT(last >> shaders::kIdBits, std::uint64_t{1} << shaders::kLogKeyBits);
        EXPECT_GE(last >> shaders::kIdBits, std::uint64_t{1} << (shaders::kLogKeyBits - 2)) << nearView;
        // A step is at most twice that of a true logarithm over the same range.
        const double octaves = std::log2(farView / nearView) + 1.0;
        EXPECT_LE(std::exp2(static_cast<int>(push.shift) - 52), 2.0 * octaves * std::exp2(-40)) << nearView;
        for (double w = nearView; w < farView; w *= 1.37) {
            const double back = scale.distanceView(logKeyOf(w, push));
            EXPECT_LE(back, w);
            EXPECT_LT(w - back, w * std::exp2(static_cast<int>(push.shift) - 52)) << w;
        }
    }
}

TEST(Rivals, FixedKeysReachTheFarPlane) {
    scene::Camera camera;
    camera.farView = 2e8;
    const KeyScale scale(parseRival("atomic-fixed").rival, camera);
    const double steps = camera.farView * static_cast<double>(scale.pushFor(1).scale);
    EXPECT_LT(steps, std::exp2(63));
    EXPECT_GE(steps, std::exp2(61));
    EXPECT_DOUBLE_EQ(scale.distanceView(static_cast<std::uint64_t>(steps)), camera.farView);
}

/// Of the smallest scenes too, for which a float32 does not hold the steps that fill all bits.
TEST(Rivals, FixedKeysOfTheNearestFarPlaneComeBack) {
    scene::Camera camera;
    camera.nearView = 1e-30;
    camera.farView = 2e-30;
    const KeyScale scale(parseRival("atomic-fixed").rival, camera);
    const float stepsPerUnit = scale.pushFor(1).scale;
    ASSERT_TRUE(std::isfinite(stepsPerUnit));
    const auto key = static_cast<std::uint64_t>(camera.farView * static_cast<double>(stepsPerUnit));
    EXPECT_NEAR(scale.distanceView(key), camera.farView, camera.nearView * 1e-7);
}

} // namespace
