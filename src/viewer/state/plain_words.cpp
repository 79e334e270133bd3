#include "plain_words.h"

#include <cdr/base/quantity_text.h>

#include <fmt/format.h>

namespace cdr::viewer {

std::string counted(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", base::quantityText(static_cast<double>(count)), noun,
                       count == 1 ? "" : "s");
}

std::string lagText(double seconds) {
    constexpr double kNoticed = 0.5;
    return seconds < kNoticed ? "" : fmt::format("rendering, {:.1f}\u00a0s behind", seconds);
}

} // namespace cdr::viewer
