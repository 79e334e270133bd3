#include <cdr/base/number_text.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace cdr::base {

namespace {

/// What `write(begin, end)` writes, in as much room as it needs.
template <typename Write>
std::string written(const Write& write) {
    // As long as the widest float64 without an exponent, and its decimals.
    std::string text(400, '\0');
    std::to_chars_result result = write(text.data(), text.data() + text.size());
    while (result.ec == std::errc::value_too_large) {
        text.resize(2 * text.size());
        result = write(text.data(), text.data() + text.size());
    }
    text.resize(static_cast<std::size_t>(result.ptr - text.data()));
    return text;
}

} // namespace

std::string shortest(double value) {
    const double size = std::abs(value);
    const auto format = size == 0.0 || !std::isfinite(size) || (size >= 1e-4 && size < 1e16)
                            ? std::chars_format::fixed
                            : std::chars_format::scientific;
    return written([&](char* begin, char* end) { return std::to_chars(begin, end, value, format); });
}

std::string general(double value, int digits) {
    return written([&](char* begin, char* end) {
        return std::to_chars(begin, end, value, std::chars_format::general, digits);
    });
}

std::string fixed(double value, int decimals) {
    return written([&](char* begin, char* end) {
        return std::to_chars(begin, end, value, std::chars_format::fixed, decimals);
    });
}

} // namespace cdr::base
