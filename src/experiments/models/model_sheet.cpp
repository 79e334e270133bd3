#include "model_sheet.h"

#include <cdr/image/compose.h>

#include <fmt/format.h>
#include <output/readable.h>

#include <array>

namespace cdr::experiments {

namespace {

constexpr std::uint32_t kModelCell = 320; ///< pixels across
constexpr std::uint32_t kModelMargin = 8;
constexpr std::uint32_t kModelCaption = 24;
constexpr std::uint32_t kModelTitle = 52;
constexpr image::Rgba8 kModelPaper{24, 26, 30, 255};
constexpr image::Rgba8 kModelInk{235, 235, 235, 255};
constexpr std::array<const char*, 4> kModelColumns{"base colour alone", "all materials", "float64 reference",
                                                   "FLIP between the two"};

} // namespace

image::ImageRgba8 makeModelSheet(const std::vector<ModelResult>& results, const std::string& title) {
    if (results.empty()) {
        return {};
    }
    const image::ImageRgba8& first = results.front().picture;
    const std::uint32_t factor = image::shrinkFactor(first, kModelCell);
    const std::uint32_t across = first.width / factor + kModelMargin;
    const std::uint32_t down = first.height / factor + kModelCaption + kModelMargin;
    const auto rows = static_cast<std::uint32_t>(results.size());
    image::ImageRgba8 sheet(kModelMargin + 4 * across, kModelTitle + rows * down, kModelPaper);
    image::drawText(sheet, title, kModelMargin, kModelMargin, 2, kModelInk);
    for (std::uint32_t column = 0; column < kModelColumns.size(); ++column) {
        image::drawText(sheet, kModelColumns[column], kModelMargin + column * across, kModelMargin + 22, 2,
                        kModelInk);
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        const ModelResult& result = results[row];
        const std::uint32_t y = kModelTitle + row * down;
        image::drawText(
            sheet, fmt::format("{}, light {}: mean FLIP {:.4f}", result.model, result.light, result.flip),
            kModelMargin, y + 4, 2, kModelInk);
        std::uint32_t x = kModelMargin;
        for (const image::ImageRgba8* picture :
             {&result.plain, &result.picture, &result.reference, &result.difference}) {
            image::paste(sheet, image::shrink(*picture, factor), x, y + kModelCaption);
            x += across;
        }
    }
    return sheet;
}

} // namespace cdr::experiments
