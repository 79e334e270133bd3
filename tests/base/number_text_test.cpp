#include <cdr/base/number_text.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace cdr::base {

namespace {

/// Float64 values of every size, and those at which the notation changes.
std::vector<double> manyNumbers() {
    std::vector<double> numbers{0.0,       -0.0,
                                1.0,       -1.0,
                                0.1,       1e-4,
                                9.9999e-5, 1e15,
                                1e16,      9999999999999998.0,
                                1e17,      1e5,
                                1e-5,      1e300,
                                5e-324,    0.5,
                                100000.0,  std::numeric_limits<double>::max()};
    std::mt19937_64 random(2013);
    while (numbers.size() < 5000) {
        const auto number = std::bit_cast<double>(random());
        if (number == number && number - number == 0.0) {
            numbers.push_back(number);
        }
        numbers.push_back(std::uniform_real_distribution(-1e3, 1e3)(random));
        numbers.push_back(static_cast<double>(random() % 100'000'000));
    }
    return numbers;
}

TEST(NumberText, IsWhatFmtWrites) {
    for (const double number : manyNumbers()) {
        ASSERT_EQ(shortest(number), fmt::format("{}", number));
        ASSERT_EQ(general(number), fmt::format("{:g}", number));
        ASSERT_EQ(general(number, 3), fmt::format("{:.3g}", number));
        ASSERT_EQ(fixed(number, 1), fmt::format("{:.1f}", number));
    }
}

TEST(NumberText, TakesAnyNumberOfDigits) {
    EXPECT_EQ(fixed(0.5, 1000), "0.5" + std::string(999, '0'));
    EXPECT_EQ(general(1e308, 309).size(), 309u);
    EXPECT_EQ(fixed(-1e308, 900).size(), 1u + 309 + 1 + 900);
}

TEST(NumberText, OfNoNumberIsItsName) {
    EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(shortest(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(NumberText, TextsAndNumbersFollowOneAnother) {
    const std::string text = "near";
    EXPECT_EQ(concat(text, " ", 0.1, ", ", 3u, " of ", std::size_t{4}), "near 0.1, 3 of 4");
}

} // namespace

} // namespace cdr::base
