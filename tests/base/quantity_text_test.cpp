#include <cdr/base/error.h>
#include <cdr/base/quantity_text.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <string>

namespace cdr::base {

namespace {

double valueOf(const nlohmann::json& value) {
    if (value.is_number()) {
        return value.get<double>();
    }
    const double infinity = std::numeric_limits<double>::infinity();
    return value == "nan" ? std::nan("") : value == "infinity" ? infinity : -infinity;
}

TEST(QuantityText, WritesTheSharedCases) {
    std::ifstream file(CDR_QUANTITIES);
    ASSERT_TRUE(file) << CDR_QUANTITIES;
    const auto cases = nlohmann::json::parse(file).at("cases");
    ASSERT_GT(cases.size(), 40u);
    for (const auto& each : cases) {
        const int digits = each.value("digits", kReadableDigits);
        for (const NumberStyle style : {NumberStyle::typeset, NumberStyle::plain}) {
            const double value = valueOf(each.at("value"));
            const std::string text =
                each.contains("unit")
                    ? quantityText(value, parseLengthUnit(each.at("unit").get<std::string>()), style, digits)
                    : quantityText(value, style, digits);
            EXPECT_EQ(text, each.at(style == NumberStyle::typeset ? "typeset" : "plain").get<std::string>())
                << each;
        }
    }
}

TEST(QuantityText, ReadsBackToWithinItsDigits) {
    std::mt19937_64 random(2013);
    for (int i = 0; i < 20'000; ++i) {
        const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
        if (!std::isnormal(value) || std::abs(value) > 1e300) {
            continue;
        }
        const std::string text = quantityText(value, NumberStyle::plain);
        EXPECT_NEAR(std::stod(text) / value, 1.0, 0.5e-3 * (1.0 + 1e-12)) << text;
        EXPECT_NEAR(std::stod(quantityText(value, NumberStyle::plain, 17)) / value, 1.0, 1e-15);
    }
}

TEST(LengthUnit, IsReadByItsName) {
    for (const LengthUnit unit : kLengthUnits) {
        EXPECT_EQ(parseLengthUnit(nameOf(unit)), unit);
    }
    EXPECT_THROW(parseLengthUnit("mile"), InputError);
}

} // namespace

} // namespace cdr::base
