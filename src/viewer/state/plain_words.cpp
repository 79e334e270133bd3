#include "plain_words.h"

#include <cdr/base/quantity_text.h>

#include <fmt/format.h>

namespace cdr::viewer {

std::string counted(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", base::quantityText(static_cast<double>(count)), noun,
                       count == 1 ? "" : "s");
}

std::string millisecondsText(double ms) {
    return base::quantityText(ms) + "\u00a0ms";
}

std::string lagText(double seconds) {
    constexpr double kNoticed = 0.5;
    constexpr int kDigits = 2; // more of them flicker
    return seconds < kNoticed ? ""
                              : fmt::format("rendering, {}\u00a0s behind",
                                            base::quantityText(seconds, base::NumberStyle::typeset, kDigits));
}

} // namespace cdr::viewer
