#include "number_checks.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace cdr::options {

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

CLI::Validator wholeNumber() {
    return CLI::Validator(
        [](const std::string& text) -> std::string {
            constexpr std::string_view kDigits = "0123456789";
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const bool isDecimal = text.find_first_not_of(kDigits) == std::string::npos;
            const bool isTooLarge =
                std::from_chars(text.data(), end, value).ec == std::errc::result_out_of_range;
            if (text.starts_with('-') || (isDecimal && isTooLarge)) {
                return fmt::format("must be a whole number from 0 to {}, not {}",
                                   std::numeric_limits<std::uint64_t>::max(), text.substr(0, 60));
            }
            return "";
        },
        "");
}

} // namespace cdr::options
