#include "checks.h"

#include <algorithm>

namespace cdr::scene::gltf {

namespace {

/// Whether a byte goes on with a character of UTF-8 that bytes before it begin.
bool isInsideCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

} // namespace

std::string oneLine(std::string_view text, std::size_t maxLength) {
    constexpr std::string_view kMore = "...";
    while (!text.empty() && text.back() == '\n') {
        text.remove_suffix(1);
    }
    std::size_t length = std::min(text.size(), maxLength);
    while (length > 0 && length < text.size() && isInsideCharacter(text[length])) {
        --length;
    }
    std::string line(text.substr(0, length));
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    if (text.size() > length) {
        line += kMore;
    }
    return line;
}

} // namespace cdr::scene::gltf
