#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/base64.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <ranks/one_process.h>
#include <runs/kept_ranks.h>
#include <runs/units.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace cdr::runs {
namespace {

/// A run of three kinds of units, of which the first rank makes the second kind, and all make the third together. A start may end
/// early.
class KeptRun : public testing::Test {
  protected:
    struct Start {
        std::vector<std::string> made{};
        std::vector<std::string> taken{};
        std::vector<bool> isWhole{}; ///< what was taken, and not as it was kept
        std::string error{};
    };

    std::filesystem::path state() const { return m_folder.path() / "s"; }

    /// @param most that it makes. @param stands of the results of earlier runs.
    Start start(
        std::size_t most = 100,
        const std::function<bool(std::size_t, const platform::Bytes&)>& stands =
            [](std::size_t, const auto&) { return true; },
        const std::string& digest = std::string(64, 'a')) const {
        Start start;
        try {
            ranks::OneProcess alone;
            KeptRanks kept(alone, state(), digest);
            kept.keepOnly(stands);
            kept.keepAs([](const platform::Bytes& bytes) {
                auto made = output::Json::from_cbor(bytes);
                EXPECT_EQ(made.erase("large"), 1u);
                return output::Json::to_cbor(made);
            });
            const auto make = [&](const std::string& name) {
                if (start.made.size() == most) {
                    throw base::RunError("stopped");
                }
                start.made.push_back(name);
                return output::Json{{"name", name},
                                    {"infinite", std::numeric_limits<double>::infinity()},
                                    {"large", start.made.size()}};
            };
            const auto take = [&](std::size_t, const output::Json& made) {
                EXPECT_EQ(made.at("infinite"), std::numeric_limits<double>::infinity());
                start.isWhole.push_back(made.contains("large"));
                start.taken.push_back(made.at("name").get<std::string>());
            };
            forEachUnit(
                kept, 3, [&](std::size_t unit) { return make("a" + std::to_string(unit)); }, take);
            forEachUnit(
                kept, 2, [&](std::size_t unit) { return make("b" + std::to_string(unit)); }, take,
                &ranks::Ranks::forEachUnitOnFirst);
            forEachUnit(
                kept, 2, [&](std::size_t unit) { return make("c" + std::to_string(unit)); }, take,
                &ranks::Ranks::forEachUnitTogether);
        } catch (const std::exception& error) {
            start.error = error.what();
        }
        return start;
    }

  private:
    test::TemporaryFolder m_folder;
};

const std::vector<std::string> kAll{"a0", "a1", "a2", "b0", "b1", "c0", "c1"};

TEST_F(KeptRun, MakesOnlyWhatIsMissingAndTakesAllInOrder) {
    for (std::size_t stop = 0; stop <= kAll.size(); ++stop) {
        std::filesystem::remove(state());
        EXPECT_EQ(start(stop).error, stop < kAll.size() ? "stopped" : "");
        const Start again = start();
        EXPECT_EQ(again.error, "");
        EXPECT_EQ(again.taken, kAll);
        EXPECT_EQ(again.made, (std::vector<std::string>(kAll.begin() + static_cast<long>(stop), kAll.end())));
        std::vector<bool> isWhole(kAll.size(), true);
        std::fill_n(isWhole.begin(), stop, false);
        EXPECT_EQ(again.isWhole, isWhole);
    }
}

TEST_F(KeptRun, MakesAgainWhatDoesNotStand) {
    EXPECT_EQ(start().made, kAll);
    const Start again = start(100, [](std::size_t unit, const platform::Bytes& made) {
        const output::Json name = output::Json::from_cbor(made).at("name");
        EXPECT_EQ(name, kAll.at(unit));
        return name != "a1" && name != "b0" && name != "c1";
    });
    EXPECT_EQ(again.made, (std::vector<std::string>{"a1", "b0", "c1"}));
    EXPECT_EQ(again.taken, kAll);
    EXPECT_TRUE(start().made.empty());
}

TEST_F(KeptRun, RefusesResultsOfAnotherShapeInOneLine) {
    const std::string digest(64, 'a');
    const std::string line =
        state().string() + ": holds results that do not fit this run; remove it or name another file";
    const auto encoded = [](const output::Json& json) {
        return output::Json(platform::toBase64(output::Json::to_cbor(json)));
    };
    const auto repeated = [](std::uint8_t head) {
        return platform::toBase64(platform::Bytes(10'000'000, head));
    };
    for (const output::Json& made :
         {output::Json(7), output::Json("?"), output::Json(platform::toBase64({})), encoded(7),
          encoded({{"other", 1}}),
          output::Json(repeated(0x81)), // lists in lists, and pieces of pieces of texts
          output::Json(repeated(0x7f)), output::Json(repeated(0x5f))}) {
        platform::writeText(state(), stateHeadOf(digest) + stateLineOf(1, made));
        EXPECT_EQ(start().error, line) << made.dump().substr(0, 80);
    }
    platform::writeText(state(), stateHeadOf(digest) + stateLineOf(1, encoded(output::Json::object())));
    EXPECT_EQ(start(100, [](std::size_t,
                            const auto& made) { return output::Json::from_cbor(made).at("name") == ""; })
                  .error,
              line);
}

TEST_F(KeptRun, IsOfOneRun) {
    EXPECT_EQ(start(2).made.size(), 2u);
    EXPECT_NE(start(
                  100, [](std::size_t, const auto&) { return true; }, std::string(64, 'b'))
                  .error.find("is the state of a run with other options or files"),
              std::string::npos);
}

} // namespace
} // namespace cdr::runs
