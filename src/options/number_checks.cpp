#include "number_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace cdr::options {

namespace {

constexpr std::string_view kDigits = "0123456789";

/// Takes leading zeros away. What is no number is left to the other checks.
std::string withoutLeadingZeros(std::string& text) {
    const std::size_t first = text.find_first_not_of("+- ");
    if (first == std::string::npos || text[first] != '0') {
        return "";
    }
    if (text.find_first_not_of(kDigits, first) != std::string::npos) {
        return fmt::format("must be a whole number in decimal, not {}", text.substr(0, 60));
    }
    text.erase(first, std::min(text.find_first_not_of('0', first), text.size() - 1) - first);
    return "";
}

/// CLI11 alone takes -1 for 2^64 - 1, and so all that is too large.
std::string refusalOfUnsigned(const std::string& text) {
    std::uint64_t value = 0;
    const bool isDecimal = text.find_first_not_of(kDigits) == std::string::npos;
    const bool isTooLarge =
        std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc::result_out_of_range;
    const std::size_t first = text.find_first_not_of(' ');
    const bool isNegative = first != std::string::npos && text[first] == '-';
    return isNegative || (isDecimal && isTooLarge)
               ? fmt::format("must be a whole number from 0 to {}, not {}",
                             std::numeric_limits<std::uint64_t>::max(), text.substr(0, 60))
               : "";
}

} // namespace

CLI::Validator numberFrom(double least, double most) {
    return CLI::Validator(
        [least, most](const std::string& text) -> std::string {
            double value = 0.0;
            if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) {
                return "";
            }
            return fmt::format("must be a number from {} to {}, not {}", least, most, text.substr(0, 60));
        },
        "");
}

void takeDecimals(CLI::App& program) {
    for (CLI::Option* option : program.get_options()) {
        const std::string type = option->get_type_name();
        if (type.starts_with("UINT") || type.starts_with("INT")) {
            option->transform(CLI::Validator(withoutLeadingZeros, ""));
        }
        if (type.starts_with("UINT")) {
            option->transform(CLI::Validator(refusalOfUnsigned, ""));
        }
    }
    for (CLI::App* command : program.get_subcommands({})) {
        takeDecimals(*command);
    }
}

} // namespace cdr::options
