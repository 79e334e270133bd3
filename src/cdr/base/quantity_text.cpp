#include <cdr/base/enum_names.h>
#include <cdr/base/number_text.h>
#include <cdr/base/quantity_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace cdr::base {

namespace {

constexpr EnumNames<LengthUnit, kLengthUnits.size()> kUnitNames{"unit",
                                                                {"none", "auto", "um", "mm", "m", "km"}};

struct MetricUnit {
    double metres;
    std::string_view typeset;
    std::string_view plain;
};
constexpr std::array<MetricUnit, 5> kMetricUnits{{{1e-6, "µm", "um"},
                                                  {1e-3, "mm", "mm"},
                                                  {1.0, "m", "m"},
                                                  {1e3, "km", "km"},
                                                  {1e9, "million\u00a0km", "million km"}}};

/// From here on, and below the other, a power of ten is written.
constexpr int kLargestExponent = 7;
constexpr int kSmallestExponent = -4;

/// A decimal number: digits, the first of them at a power of ten.
struct Decimal {
    std::string digits;
    int exponent = 0;
};

/// Far more digits than decide how the last one that is kept is rounded.
constexpr int kExactDigits = 40;

Decimal decimalOf(double size) {
    std::array<char, kExactDigits + 16> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), size,
                                            std::chars_format::scientific, kExactDigits);
    const std::string_view all(text.data(), static_cast<std::size_t>(end - text.data()));
    const std::size_t mark = all.find('e');
    Decimal decimal;
    std::copy_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(mark),
                 std::back_inserter(decimal.digits), [](char c) { return c != '.'; });
    const std::size_t from = mark + (all[mark + 1] == '+' ? 2 : 1);
    std::from_chars(all.data() + from, all.data() + all.size(), decimal.exponent);
    return decimal;
}

/// Half a step goes up.
Decimal rounded(Decimal decimal, std::size_t kept) {
    const bool goesUp = decimal.digits[kept] >= '5';
    decimal.digits.resize(kept);
    if (goesUp) {
        const auto last =
            std::find_if(decimal.digits.rbegin(), decimal.digits.rend(), [](char c) { return c != '9'; });
        std::fill(decimal.digits.rbegin(), last, '0');
        if (last != decimal.digits.rend()) {
            ++*last;
        } else {
            decimal.digits.insert(0, 1, '1');
            ++decimal.exponent;
        }
    }
    decimal.digits.erase(decimal.digits.find_last_not_of('0') + 1);
    return decimal;
}

std::string grouped(const std::string& whole) {
    std::string text;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        text += i > 0 && (whole.size() - i) % 3 == 0 ? "," : "";
        text += whole[i];
    }
    return text;
}

std::string raised(int exponent) {
    constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(exponent)) {
        text += c == '-' ? "⁻" : kRaised.at(static_cast<std::size_t>(c - '0'));
    }
    return text;
}

std::string withPoint(const std::string& whole, const std::string& fraction) {
    return fraction.empty() ? whole : whole + "." + fraction;
}

std::string withPower(const Decimal& decimal, NumberStyle style) {
    const std::string mantissa = withPoint(decimal.digits.substr(0, 1), decimal.digits.substr(1));
    return style == NumberStyle::typeset ? mantissa + "·10" + raised(decimal.exponent)
                                         : concat(mantissa, "e", decimal.exponent);
}

std::string withoutPower(const Decimal& decimal, NumberStyle style) {
    if (decimal.exponent < 0) {
        return withPoint("0",
                         std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + decimal.digits);
    }
    const auto places = static_cast<std::size_t>(decimal.exponent) + 1;
    std::string whole = decimal.digits.substr(0, places);
    whole.resize(places, '0');
    const std::string fraction = decimal.digits.size() > places ? decimal.digits.substr(places) : "";
    return withPoint(style == NumberStyle::typeset ? grouped(whole) : whole, fraction);
}

Decimal readable(double size, int digits) {
    const Decimal decimal = decimalOf(size);
    const int whole = decimal.exponent < kLargestExponent ? decimal.exponent + 1 : 0;
    return rounded(decimal, static_cast<std::size_t>(std::clamp(std::max(digits, whole), 1, kExactDigits)));
}

const MetricUnit& unitOf(double metres, LengthUnit unit, int digits) {
    if (unit != LengthUnit::automatic) {
        return kMetricUnits.at(static_cast<std::size_t>(unit) -
                               static_cast<std::size_t>(LengthUnit::micrometre));
    }
    if (metres == 0.0 || !std::isfinite(metres)) {
        return kMetricUnits[2];
    }
    // What rounds up to a unit fills it.
    const auto larger =
        std::find_if(kMetricUnits.begin() + 1, kMetricUnits.end(), [&](const MetricUnit& each) {
            const double size =
                std::abs(metres) / each.metres; // infinite of the largest numbers in small units
            return std::isfinite(size) && readable(size, digits).exponent < 0;
        });
    return *std::prev(larger);
}

} // namespace

std::string_view nameOf(LengthUnit unit) {
    return kUnitNames.nameOf(unit);
}

LengthUnit parseLengthUnit(std::string_view name) {
    return kUnitNames.parse(name);
}

std::string quantityText(double value, NumberStyle style, int digits) {
    if (std::isnan(value)) {
        return "none";
    }
    const std::string sign = !(value < 0.0) ? "" : style == NumberStyle::typeset ? "\u2212" : "-";
    if (std::isinf(value)) {
        return sign + "infinite";
    }
    if (value == 0.0) {
        return "0";
    }
    const Decimal decimal = readable(std::abs(value), digits);
    const bool hasPower = decimal.exponent < kSmallestExponent || decimal.exponent >= kLargestExponent;
    return sign + (hasPower ? withPower(decimal, style) : withoutPower(decimal, style));
}

std::string quantityText(double metres, LengthUnit unit, NumberStyle style, int digits) {
    if (unit == LengthUnit::none || !std::isfinite(metres)) {
        return quantityText(metres, style, digits);
    }
    const MetricUnit& metric = unitOf(metres, unit, digits);
    const bool isTypeset = style == NumberStyle::typeset;
    return concat(quantityText(metres / metric.metres, style, digits), isTypeset ? "\u00a0" : " ",
                  isTypeset ? metric.typeset : metric.plain);
}

} // namespace cdr::base
