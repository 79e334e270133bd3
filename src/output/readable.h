#pragma once

#include <cdr/base/quantity_text.h>

#include <fmt/format.h>

namespace cdr::output {

/// A number that fmt writes as base::quantityText() does on terminals; "{:+}" puts a sign before a positive one too.
struct Readable {
    double value = 0.0;
    base::LengthUnit unit = base::LengthUnit::none; ///< of a length
};

/// A share of 1.
constexpr Readable percent(double share) {
    return {100.0 * share};
}

} // namespace cdr::output

template <>
struct fmt::formatter<cdr::output::Readable> {
    bool hasPlus = false;

    constexpr auto parse(fmt::format_parse_context& context) {
        const auto* at = context.begin();
        if (at != context.end() && *at == '+') {
            hasPlus = true;
            ++at;
        }
        return at;
    }

    template <typename Context>
    auto format(const cdr::output::Readable& number, Context& context) const {
        return fmt::format_to(
            context.out(), "{}{}", hasPlus && number.value > 0.0 ? "+" : "",
            cdr::base::quantityText(number.value, number.unit, cdr::base::NumberStyle::plain));
    }
};
