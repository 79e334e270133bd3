#include <cdr/scene/animation/pose.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::scene {

namespace {

Keyframes keyframesOf(Interpolation interpolation, std::size_t width, std::vector<float> times,
                      std::vector<float> values) {
    Keyframes keyframes;
    keyframes.interpolation = interpolation;
    keyframes.width = width;
    keyframes.times = std::move(times);
    keyframes.values = std::move(values);
    return keyframes;
}

double numberAt(const Keyframes& keyframes, double seconds) {
    double value = 0.0;
    sampleAt(keyframes, seconds, {&value, 1});
    return value;
}

/// A turn about z, in radians.
double turnAt(const Keyframes& keyframes, double seconds) {
    const glm::dquat turn = rotationAt(keyframes, seconds);
    EXPECT_NEAR(glm::length(turn), 1.0, 1e-15);
    return 2.0 * std::atan2(turn.z, turn.w);
}

std::vector<float> aboutZ(const std::vector<double>& angles) {
    std::vector<float> values;
    for (const double angle : angles) {
        values.insert(values.end(), {0.0f, 0.0f, static_cast<float>(std::sin(angle / 2.0)),
                                     static_cast<float>(std::cos(angle / 2.0))});
    }
    return values;
}

TEST(Keyframes, StepsHoldUntilTheNext) {
    const Keyframes steps = keyframesOf(Interpolation::step, 1, {1.0f, 2.0f, 4.0f}, {5.0f, 7.0f, 6.0f});
    EXPECT_EQ(numberAt(steps, 0.0), 5.0);
    EXPECT_EQ(numberAt(steps, 1.999), 5.0);
    EXPECT_EQ(numberAt(steps, 2.0), 7.0);
    EXPECT_EQ(numberAt(steps, 3.999), 7.0);
    EXPECT_EQ(numberAt(steps, 99.0), 6.0);
}

TEST(Keyframes, LinearOnesLieOnALine) {
    const Keyframes line = keyframesOf(Interpolation::linear, 1, {1.0f, 3.0f}, {10.0f, 20.0f});
    EXPECT_EQ(numberAt(line, 0.5), 10.0);
    EXPECT_EQ(numberAt(line, 1.5), 12.5);
    EXPECT_EQ(numberAt(line, 3.0), 20.0);
    EXPECT_EQ(numberAt(line, 5.0), 20.0);
}

/// A cubic is its own Hermite spline, from its values and slopes.
TEST(Keyframes, CubicSplinesGiveACubicBack) {
    const auto cubic = [](double t) { return 2.0 * t * t * t - 3.0 * t * t + 0.5 * t + 4.0; };
    const auto slope = [](double t) { return 6.0 * t * t - 6.0 * t + 0.5; };
    std::vector<float> values;
    const std::vector<float> times{0.0f, 0.5f, 2.0f};
    for (const double t : {0.0, 0.5, 2.0}) {
        for (const double part : {slope(t), cubic(t), slope(t)}) {
            values.push_back(static_cast<float>(part));
        }
    }
    const Keyframes spline = keyframesOf(Interpolation::cubicSpline, 1, times, values);
    for (double t = 0.0; t <= 2.0; t += 0.05) {
        EXPECT_NEAR(numberAt(spline, t), cubic(t), 1e-13) << t;
    }
    EXPECT_EQ(numberAt(spline, 9.0), static_cast<double>(static_cast<float>(cubic(2.0))));
}

/// A spline's rotation is that of its number, made as long as one.
TEST(Keyframes, RotationsOfSplinesHaveLengthOne) {
    std::vector<float> values;
    for (const double angle : {0.0, 1.0}) {
        values.insert(values.end(), 4, 0.0f);
        const std::vector<float> turn = aboutZ({angle});
        values.insert(values.end(), turn.begin(), turn.end());
        values.insert(values.end(), 4, 0.0f);
    }
    const Keyframes spline = keyframesOf(Interpolation::cubicSpline, 4, {0.0f, 2.0f}, values);
    EXPECT_NEAR(turnAt(spline, 1.0), 0.5, 1e-7); // halfway by symmetry
    EXPECT_NEAR(turnAt(spline, 0.5),
                2.0 * std::atan2(0.15625 * std::sin(0.5), 0.84375 + 0.15625 * std::cos(0.5)), 1e-7);
}

TEST(Keyframes, LinearRotationsTurnEvenlyByTheShorterWay) {
    const Keyframes even = keyframesOf(Interpolation::linear, 4, {0.0f, 1.0f}, aboutZ({0.2, 1.4}));
    for (double t = 0.0; t <= 1.0; t += 0.1) {
        EXPECT_NEAR(turnAt(even, t), 0.2 + 1.2 * t, 1e-6) << t;
    }
    std::vector<float> opposite = aboutZ({0.2, 1.4});
    for (std::size_t i = 4; i < 8; ++i) {
        opposite[i] = -opposite[i]; // the same rotation, the other quaternion
    }
    EXPECT_NEAR(turnAt(keyframesOf(Interpolation::linear, 4, {0.0f, 1.0f}, opposite), 0.5), 0.8, 1e-6);
}

/// An arm of two turning parts: the tip's place follows from two angles.
TEST(Pose, ChainsFollowTheirParents) {
    Rig rig;
    rig.nodes.resize(3);
    rig.nodes[0].parentToWorld[3] = {100.0, 0.0, 0.0, 1.0};
    rig.nodes[1].parent = 0;
    rig.nodes[1].local.translation = {2.0, 0.0, 0.0};
    rig.nodes[2].parent = 1;
    rig.nodes[2].local.translation = {3.0, 0.0, 0.0};
    Animation animation;
    animation.keyframes = {keyframesOf(Interpolation::linear, 4, {0.0f, 1.0f}, aboutZ({0.0, 1.0})),
                           keyframesOf(Interpolation::linear, 4, {0.0f, 1.0f}, aboutZ({0.0, 0.7}))};
    animation.channels = {{.keyframes = 0, .node = 0, .path = AnimatedPath::rotation},
                          {.keyframes = 1, .node = 1, .path = AnimatedPath::rotation}};
    for (const double t : {0.0, 0.3, 1.0}) {
        const glm::dvec3 tip(poseAt(rig, &animation, t).toWorld[2][3]);
        EXPECT_NEAR(tip.x, 100.0 + 2.0 * std::cos(t) + 3.0 * std::cos(1.7 * t), 1e-6);
        EXPECT_NEAR(tip.y, 2.0 * std::sin(t) + 3.0 * std::sin(1.7 * t), 1e-6);
    }
    EXPECT_EQ(glm::dvec3(poseAt(rig, nullptr, 0.5).toWorld[2][3]), glm::dvec3(105.0, 0.0, 0.0));
    animation.channels.erase(animation.channels.begin());
    EXPECT_EQ(movedBy(rig, animation), (std::vector<bool>{false, true, true}));
}

} // namespace

} // namespace cdr::scene
