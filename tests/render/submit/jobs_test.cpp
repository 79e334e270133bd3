#include <cdr/render/submit/secondary_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cdr::render_test {

namespace {

/// Lists of these many compact and wide draws per cascade; which instances they are does not matter.
visibility::DrawLists listsOf(const std::vector<std::pair<std::size_t, std::size_t>>& cascades) {
    visibility::DrawLists lists;
    for (const auto& [compact, wide] : cascades) {
        lists.begins.push_back(lists.begins.back() + compact);
        lists.begins.push_back(lists.begins.back() + wide);
    }
    lists.instance.resize(lists.draws());
    return lists;
}

TEST(Jobs, CoverEveryDrawOnceInOrder) {
    std::mt19937 random(2013);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::pair<std::size_t, std::size_t>> cascades(1 + random() % 8);
        for (auto& [compact, wide] : cascades) {
            compact = random() % 3 == 0 ? 0 : random() % 5000;
            wide = random() % 2 == 0 ? 0 : random() % 50;
        }
        const visibility::DrawLists lists = listsOf(cascades);
        for (const std::size_t threads : {1u, 2u, 3u, 16u}) {
            std::size_t next = 0;
            std::size_t cascade = 0;
            for (const render::DrawJob& job : render::makeJobs(lists, threads)) {
                EXPECT_EQ(job.draws.begin, next);
                EXPECT_GT(job.draws.size(), 0u);
                EXPECT_GE(job.cascade, cascade);
                EXPECT_GE(job.draws.begin, lists.range(job.cascade).begin);
                EXPECT_LE(job.draws.end, lists.range(job.cascade).end);
                next = job.draws.end;
                cascade = job.cascade;
            }
            EXPECT_EQ(next, lists.draws());
        }
    }
}

/// One thread needs no more than one job a cascade; several share the largest cascade evenly.
TEST(Jobs, AreBalancedByDraws) {
    const visibility::DrawLists lists = listsOf({{100, 0}, {0, 0}, {60'000, 7}});
    EXPECT_EQ(render::makeJobs(lists, 1).size(), 2u);
    const std::vector<render::DrawJob> jobs = render::makeJobs(lists, 4);
    EXPECT_GE(jobs.size(), 16u);
    const auto most = std::ranges::max_element(jobs, {}, [](const auto& job) { return job.draws.size(); });
    EXPECT_LE(most->draws.size(), lists.draws() / 16 + 1);
}

} // namespace

} // namespace cdr::render_test
