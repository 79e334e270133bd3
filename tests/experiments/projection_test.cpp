#include <experiments/scaling/projection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace cdr::experiments {
namespace {

/// 40 ms to make, 1 ms to take, 1 ms to claim, 1 ms to send.
FrameCosts evenCosts() {
    return {.makeMs = {40.0, 40.0, 40.0},
            .takeMs = {1.0, 1.0},
            .bytes = 1000.0,
            .claimMs = 1.0,
            .msPerByte = 0.001};
}

TEST(Projection, DividesWhatIsMadeAndTakesInOnePlace) {
    const Projection one = project(evenCosts(), 1, 1000, 1);
    EXPECT_DOUBLE_EQ(one.seconds, 42.0);
    EXPECT_DOUBLE_EQ(one.efficiency, 1.0);
    EXPECT_EQ(one.bound, ProjectionBound::making);
    const Projection ten = project(evenCosts(), 10, 1000, 1);
    EXPECT_DOUBLE_EQ(ten.seconds, 4.2);
    EXPECT_DOUBLE_EQ(ten.efficiency, 1.0);
    const Projection many = project(evenCosts(), 500, 1000, 1);
    EXPECT_DOUBLE_EQ(many.seconds, 2.0); // 1000 results at 2 ms each
    EXPECT_EQ(many.bound, ProjectionBound::taking);
    EXPECT_DOUBLE_EQ(many.efficiency, 42.0 / (500 * 2.0));
    EXPECT_EQ(lastUsefulNodes(evenCosts(), 1000), 21u);
}

TEST(Projection, EndsWhereEachNodeHasOneFrame) {
    const Projection few = project(evenCosts(), 20, 10, 1);
    EXPECT_DOUBLE_EQ(few.seconds, 0.041);
    EXPECT_EQ(few.bound, ProjectionBound::frames);
    EXPECT_EQ(lastUsefulNodes(evenCosts(), 10), 11u); // the first one has none to make then
}

/// With four nodes and nine frames, one node makes three.
TEST(Projection, IsBoundByTheLongestOfItsTimes) {
    const Projection uneven = project(evenCosts(), 4, 9, 1);
    EXPECT_DOUBLE_EQ(uneven.seconds, 3 * 0.041);
    EXPECT_EQ(uneven.bound, ProjectionBound::frames);
    EXPECT_EQ(project(evenCosts(), 4, 8, 1).bound, ProjectionBound::making);
}

/// The least number that no larger one is quicker than.
std::size_t lastUsefulByTrying(const FrameCosts& costs, std::size_t frames) {
    std::size_t best = 2 * frames + 4;
    double least = project(costs, best, frames, 1).seconds;
    for (std::size_t nodes = best - 1; nodes >= 1; --nodes) {
        const double seconds = project(costs, nodes, frames, 1).seconds;
        if (seconds <= least * (1.0 + 1e-12)) {
            best = nodes;
            least = std::min(least, seconds);
        }
    }
    return best;
}

TEST(Projection, NoNodesBeyondTheLastUsefulOnesHelp) {
    EXPECT_EQ(lastUsefulNodes(evenCosts(), 30), 30u);
    for (const double take : {0.0, 0.25, 1.0, 7.0, 60.0}) {
        for (const double claim : {0.0, 1.0, 9.0}) {
            for (const double send : {0.0, 0.001, 0.05}) {
                FrameCosts costs = evenCosts();
                costs.takeMs = {take};
                costs.claimMs = claim;
                costs.msPerByte = send;
                for (const std::size_t frames : {1u, 2u, 9u, 10u, 30u, 41u, 100u}) {
                    EXPECT_EQ(lastUsefulNodes(costs, frames), lastUsefulByTrying(costs, frames))
                        << take << " " << claim << " " << send << " " << frames;
                }
            }
        }
    }
}

TEST(Projection, NeverRunsShorterThanItsBoundsAndWidensWithItsCosts) {
    FrameCosts costs = evenCosts();
    costs.makeMs = {30.0, 34.0, 38.0, 42.0, 46.0, 50.0};
    costs.takeMs.resize(6, 1.0);
    double last = project(costs, 1, 300, 1).seconds;
    for (std::size_t nodes = 2; nodes < 400; ++nodes) {
        const Projection projection = project(costs, nodes, 300, 1);
        EXPECT_LE(projection.seconds, last) << nodes;
        EXPECT_LE(projection.secondsInterval.value().low, projection.seconds);
        EXPECT_GE(projection.secondsInterval.value().high, projection.seconds);
        EXPECT_LE(projection.efficiency, 1.0 + 1e-12);
        last = projection.seconds;
    }
    EXPECT_LT(project(costs, 2, 300, 1).secondsInterval.value().low, project(costs, 2, 300, 1).seconds);
}

TEST(Projection, HasAnIntervalWhereBothCostsHaveOne) {
    FrameCosts costs = evenCosts();
    costs.makeMs.resize(6, 40.0);
    costs.takeMs.resize(5, 1.0);
    EXPECT_FALSE(project(costs, 2, 300, 1).secondsInterval.has_value());
    costs.takeMs.resize(6, 1.0);
    EXPECT_TRUE(project(costs, 2, 300, 1).secondsInterval.has_value());
    costs.makeMs.resize(5);
    EXPECT_FALSE(project(costs, 2, 300, 1).secondsInterval.has_value());
}

} // namespace
} // namespace cdr::experiments
