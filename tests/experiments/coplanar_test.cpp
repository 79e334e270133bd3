#include <experiments/coplanar/coplanar.h>

#include <gtest/gtest.h>

#include <optional>

namespace cdr::experiments_test {

using experiments::CoplanarResult;

namespace {

TEST(CoplanarResult, HasNoShareOfNoPixels) {
    EXPECT_EQ((CoplanarResult{.pixels = 8, .wrong = 2}.wrongShare()), 0.25);
    EXPECT_EQ((CoplanarResult{.pixels = 8}.wrongShare()), 0.0);
    EXPECT_EQ(CoplanarResult{}.wrongShare(), std::nullopt);
}

} // namespace

} // namespace cdr::experiments_test
