#include <cdr/image/same_size.h>
#include <cdr/measure/compare/cracks.h>

#include <algorithm>

namespace cdr::measure {

namespace {

/// Whether a picture shows `pixel`'s object, anything as far away, or a silhouette in or around a place.
bool isExplained(const SeenImage& whole, std::uint32_t x, std::uint32_t y, const SeenPixel& pixel,
                 std::uint32_t reach) {
    const std::uint32_t left = x - std::min(x, reach);
    const std::uint32_t top = y - std::min(y, reach);
    const std::uint32_t right = std::min(whole.width, x + reach + 1);
    const std::uint32_t bottom = std::min(whole.height, y + reach + 1);
    for (std::uint32_t row = top; row < bottom; ++row) {
        for (std::uint32_t column = left; column < right; ++column) {
            const SeenPixel& around = whole.at(column, row);
            if (around.id == pixel.id || around.id != whole.at(x, y).id ||
                around.distanceView >= pixel.distanceView) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<Crack> findCracks(const SeenImage& shown, const SeenImage& whole, std::uint32_t reach) {
    image::requireSameSize(shown, whole, "cracks");
    std::vector<Crack> cracks;
    for (std::uint32_t y = 0; y < shown.height; ++y) {
        for (std::uint32_t x = 0; x < shown.width; ++x) {
            const SeenPixel& pixel = shown.at(x, y);
            if (!isExplained(whole, x, y, pixel, reach)) {
                cracks.push_back({x, y, pixel.id});
            }
        }
    }
    return cracks;
}

} // namespace cdr::measure
