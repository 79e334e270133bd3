#include <cdr/base/number_text.h>

#include <array>
#include <charconv>
#include <cmath>

namespace cdr::base {

namespace {

/// As long as the widest float64 without an exponent, and its decimals.
using NumberBuffer = std::array<char, 400>;

} // namespace

std::string shortest(double value) {
    NumberBuffer buffer;
    const double size = std::abs(value);
    const auto format = size == 0.0 || !std::isfinite(size) || (size >= 1e-4 && size < 1e16)
                            ? std::chars_format::fixed
                            : std::chars_format::scientific;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format);
    return {buffer.data(), end};
}

std::string general(double value, int digits) {
    NumberBuffer buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                            std::chars_format::general, digits);
    return {buffer.data(), end};
}

std::string fixed(double value, int decimals) {
    NumberBuffer buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                            std::chars_format::fixed, decimals);
    return {buffer.data(), end};
}

} // namespace cdr::base
