#include <gtest/gtest.h>
#include <ranks/cpu_division.h>

#include <algorithm>
#include <vector>

namespace cdr::ranks {
namespace {

using Parts = std::vector<Cpus>;

void expectDivided(const Parts& allowed, CpuChoice choice, const Parts& parts) {
    const CpuDivision division = divideCpus(allowed);
    EXPECT_EQ(nameOf(division.choice), nameOf(choice));
    EXPECT_EQ(division.parts, parts);
}

TEST(CpuDivision, FollowsWhatMpiBound) {
    expectDivided({{3}}, CpuChoice::followed, {{3}});
    expectDivided({{0, 1}, {2, 3}}, CpuChoice::followed, {{0, 1}, {2, 3}});
    expectDivided({{6}, {0, 1, 2}, {4, 7}}, CpuChoice::followed, {{6}, {0, 1, 2}, {4, 7}});
}

TEST(CpuDivision, SharesWhatAllMayUse) {
    expectDivided({{0, 1, 2, 3}, {0, 1, 2, 3}}, CpuChoice::shared, {{0, 1}, {2, 3}});
    expectDivided({{4, 5, 9}, {4, 5, 9}}, CpuChoice::shared, {{4}, {5, 9}});
    // Bound to sockets, two ranks on each.
    expectDivided({{0, 1}, {2, 3}, {0, 1}, {2, 3}}, CpuChoice::shared, {{0}, {2}, {1}, {3}});
}

TEST(CpuDivision, GivesEachRankACpuWhereThereAreTooFew) {
    expectDivided({{5}, {5}, {5}}, CpuChoice::shared, {{5}, {5}, {5}});
    expectDivided(Parts(5, {1, 8}), CpuChoice::shared, {{1}, {1}, {1}, {8}, {8}});
    // Cores that MPI binds two ranks to.
    expectDivided({{0}, {1}, {0}, {1}}, CpuChoice::shared, {{0}, {1}, {0}, {1}});
    expectDivided({{0, 1}, {0}, {0, 1}}, CpuChoice::overlapping, {{1}, {0}, {0}});
}

TEST(CpuDivision, DealsOutWhatOverlapsInPart) {
    expectDivided({{0, 1, 2, 3}, {2, 3, 4, 5}}, CpuChoice::overlapping, {{0, 1, 2}, {3, 4, 5}});
    expectDivided({{0, 1, 2, 3}, {0}}, CpuChoice::overlapping, {{1, 2, 3}, {0}});
    // The first and the last meet by way of the one between them alone; the fourth is apart.
    expectDivided({{0, 1}, {1, 2}, {2, 3}, {7}}, CpuChoice::overlapping, {{0}, {1, 2}, {3}, {7}});
    // A rank that comes last brings two groups together.
    expectDivided({{0}, {1}, {0, 1, 2}}, CpuChoice::overlapping, {{0}, {1}, {2}});
}

TEST(CpuDivision, KnowsNothingWhereOneRankCannotTell) {
    expectDivided({{0, 1}, {}}, CpuChoice::unknown, {{}, {}});
    EXPECT_EQ(nameOf(CpuChoice::unknown), "unknown");
    EXPECT_EQ(nameOf(CpuChoice::overlapping), "overlapping");
}

/// For all masks, each rank has a CPU and none that it may not use. CPUs are shared only if there are too few.
TEST(CpuDivision, HoldsForAllMasksOfThreeCpus) {
    const auto cpusOf = [](unsigned mask) {
        Cpus cpus;
        for (std::size_t cpu = 0; cpu < 3; ++cpu) {
            if ((mask >> cpu & 1u) != 0) {
                cpus.push_back(cpu);
            }
        }
        return cpus;
    };
    for (unsigned masks = 0; masks < 8 * 8 * 8; ++masks) {
        const Parts allowed{cpusOf(masks % 8), cpusOf(masks / 8 % 8), cpusOf(masks / 64)};
        if (masks % 8 == 0 || masks / 8 % 8 == 0 || masks / 64 == 0) {
            continue;
        }
        const CpuDivision division = divideCpus(allowed);
        std::vector<int> users(3, 0);
        Cpus used;
        for (std::size_t rank = 0; rank < 3; ++rank) {
            EXPECT_FALSE(division.parts[rank].empty()) << masks;
            EXPECT_TRUE(std::includes(allowed[rank].begin(), allowed[rank].end(),
                                      division.parts[rank].begin(), division.parts[rank].end()))
                << masks;
            for (const std::size_t cpu : division.parts[rank]) {
                ++users[cpu];
            }
        }
        unsigned all = masks % 8 | masks / 8 % 8 | masks / 64;
        for (std::size_t cpu = 0; cpu < 3; ++cpu) {
            EXPECT_EQ(users[cpu] > 0, (all >> cpu & 1u) != 0) << masks << ", CPU " << cpu;
        }
        if (division.choice == CpuChoice::followed) {
            EXPECT_EQ(division.parts, allowed);
        }
    }
}

} // namespace
} // namespace cdr::ranks
