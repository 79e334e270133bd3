#include "pictures.h"

#include <cdr/image/compose.h>

#include <fmt/format.h>
#include <output/readable.h>

#include <algorithm>
#include <optional>

namespace cdr::experiments {

namespace {

constexpr std::uint32_t kCellWidth = 320;
constexpr std::uint32_t kMargin = 8;
constexpr std::uint32_t kCaption = 24;
constexpr std::uint32_t kTitle = 32;
constexpr image::Rgba8 kPaper{24, 26, 30, 255};
constexpr image::Rgba8 kInk{235, 235, 235, 255};
constexpr image::Rgba8 kFaint{160, 164, 170, 255};

/// Text that shrinks to fit its cell.
void caption(image::ImageRgba8& sheet, const std::string& text, std::uint32_t x, std::uint32_t y,
             const image::Rgba8& color) {
    const std::uint32_t scale = image::textWidth(text, 2) <= kCellWidth ? 2 : 1;
    image::drawText(sheet, text, x, y, scale, color);
}

std::string wrongText(const measure::WrongPixels& wrong) {
    const std::optional<double> share = wrong.fraction();
    return share ? fmt::format("{} %", output::percent(*share)) : "no pixel off edges";
}

} // namespace

image::ImageRgba8 makeContactSheet(const std::vector<PictureResult>& results, const std::string& title) {
    if (results.empty()) {
        return {};
    }
    const auto alike = std::ranges::count_if(
        results, [&](const auto& result) { return result.technique == results.front().technique; });
    const std::uint32_t rows = std::max(1u, static_cast<std::uint32_t>(alike)); // the first is like itself
    const std::uint32_t columns = static_cast<std::uint32_t>(results.size()) / rows;
    const image::ImageRgba8& first = results.front().picture;
    const std::uint32_t factor = image::shrinkFactor(first, kCellWidth);
    const std::uint32_t cellHeight = first.height / factor;
    const std::uint32_t rowHeight = 2 * (cellHeight + kMargin) + kCaption;
    image::ImageRgba8 sheet(kMargin + columns * (first.width / factor + kMargin), kTitle + rows * rowHeight,
                            kPaper);
    image::drawText(sheet, title, kMargin, kMargin, 2, kFaint);
    for (std::uint32_t i = 0; i < results.size(); ++i) {
        const PictureResult& result = results[i];
        const std::uint32_t x = kMargin + (i % columns) * (first.width / factor + kMargin);
        const std::uint32_t y = kTitle + (i / columns) * rowHeight;
        caption(sheet, fmt::format("{} {}: {}", result.scene, result.technique, wrongText(result.wrong)), x,
                y + 4, kInk);
        image::paste(sheet, image::shrink(result.picture, factor), x, y + kCaption);
        image::paste(sheet, image::shrink(result.heatMap, factor), x, y + kCaption + cellHeight + kMargin);
    }
    return sheet;
}

} // namespace cdr::experiments
