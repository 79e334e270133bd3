#include "checks.h"

#include <algorithm>

namespace cdr::scene::gltf {

std::string oneLine(std::string_view text, std::size_t maxLength) {
    constexpr std::string_view kMore = "...";
    while (!text.empty() && text.back() == '\n') {
        text.remove_suffix(1);
    }
    std::string line(text.substr(0, maxLength));
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    if (text.size() > maxLength) {
        line += kMore;
    }
    return line;
}

} // namespace cdr::scene::gltf
