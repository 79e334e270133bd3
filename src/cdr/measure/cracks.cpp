#include <cdr/base/error.h>
#include <cdr/measure/cracks.h>

#include <algorithm>

namespace cdr::measure {

namespace {

bool isNearby(const SeenImage& whole, std::uint32_t x, std::uint32_t y, std::uint32_t id,
              std::uint32_t reach) {
    const std::uint32_t left = x - std::min(x, reach);
    const std::uint32_t top = y - std::min(y, reach);
    const std::uint32_t right = std::min(whole.width, x + reach + 1);
    const std::uint32_t bottom = std::min(whole.height, y + reach + 1);
    for (std::uint32_t row = top; row < bottom; ++row) {
        for (std::uint32_t column = left; column < right; ++column) {
            if (whole.at(column, row).id == id) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<Crack> findCracks(const SeenImage& shown, const SeenImage& whole, std::uint32_t reach) {
    if (shown.width != whole.width || shown.height != whole.height) {
        throw base::InputError("cracks: the pictures differ in size");
    }
    std::vector<Crack> cracks;
    for (std::uint32_t y = 0; y < shown.height; ++y) {
        for (std::uint32_t x = 0; x < shown.width; ++x) {
            const SeenPixel& pixel = shown.at(x, y);
            const bool isBehind = pixel.distanceView > whole.at(x, y).distanceView;
            if (isBehind && !isNearby(whole, x, y, pixel.id, reach)) {
                cracks.push_back({x, y, pixel.id});
            }
        }
    }
    return cracks;
}

} // namespace cdr::measure
