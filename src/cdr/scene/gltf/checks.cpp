#include "checks.h"

#include <cdr/platform/file.h>

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
    // Names may be millions of bytes long and shown as often, so what follows is not looked at.
    const bool isLonger = text.size() > maxLength + 1;
    text = text.substr(0, maxLength + 1);
    while (!text.empty() && text.back() == '\n') {
        text.remove_suffix(1);
    }
    std::size_t length = std::min(text.size(), maxLength);
    while (length > 0 && length < text.size() && isInsideCharacter(text[length])) {
        --length;
    }
    std::string line = platform::withoutControls(std::string(text.substr(0, length)));
    if (isLonger || text.size() > length) {
        line += kMore;
    }
    return line;
}

} // namespace cdr::scene::gltf
