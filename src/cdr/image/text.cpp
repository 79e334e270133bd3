#include <cdr/image/compose.h>

#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cdr::image {

namespace {

/// A corner as stb_easy_font writes it.
struct Corner {
    float x, y, z;
    std::array<unsigned char, 4> color;
};
static_assert(sizeof(Corner) == 16);

/// Text with a question mark for each character that the font lacks, which would read beyond its tables.
std::string inFont(const std::string& text) {
    std::string known;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool isRest = (byte & 0xc0u) == 0x80u; // of a character in UTF-8
        if (!isRest) {
            known += c == '\n' || (byte >= ' ' && byte <= '~') ? c : '?';
        }
    }
    return known;
}

void fill(ImageRgba8& target, const Corner* quad, std::uint32_t x, std::uint32_t y, std::uint32_t scale,
          const Rgba8& color) {
    const auto place = [scale](std::uint32_t origin, float offset) {
        return origin + static_cast<std::uint32_t>(std::lround(offset)) * scale;
    };
    const std::uint32_t right = std::min(place(x, quad[2].x), target.width);
    const std::uint32_t bottom = std::min(place(y, quad[2].y), target.height);
    for (std::uint32_t row = place(y, quad[0].y); row < bottom; ++row) {
        for (std::uint32_t column = place(x, quad[0].x); column < right; ++column) {
            target.at(column, row) = color;
        }
    }
}

} // namespace

void drawText(ImageRgba8& target, const std::string& text, std::uint32_t x, std::uint32_t y,
              std::uint32_t scale, const Rgba8& color) {
    // The font needs about 270 bytes a character.
    std::vector<Corner> corners(text.size() * 24 + 4);
    std::string mutableText = inFont(text);
    const int quads = stb_easy_font_print(0.0f, 0.0f, mutableText.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Corner)));
    for (int i = 0; i < quads; ++i) {
        fill(target, &corners[static_cast<std::size_t>(i) * 4], x, y, scale, color);
    }
}

std::uint32_t textWidth(const std::string& text, std::uint32_t scale) {
    std::string mutableText = inFont(text);
    return static_cast<std::uint32_t>(stb_easy_font_width(mutableText.data())) * scale;
}

} // namespace cdr::image
