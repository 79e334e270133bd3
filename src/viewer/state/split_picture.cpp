#include "split_picture.h"

#include "picture_parts.h"

#include <cdr/image/same_size.h>

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

std::uint32_t dividerColumn(double share, std::uint32_t width) {
    // Written so that what is not a number becomes 0.
    const double held = share > 0.0 ? std::min(share, 1.0) : 0.0;
    return static_cast<std::uint32_t>(std::lround(held * width));
}

void composeSplit(const image::ImageRgba8& left, const image::ImageRgba8& right, double divider,
                  image::ImageRgba8& picture) {
    image::requireSameSize(left, right, "split screen");
    resize(picture, left.width, left.height);
    const std::uint32_t column = dividerColumn(divider, left.width);
    const bool hasLine = column > 0 && column < left.width;
    constexpr image::Rgba8 kLine{235, 235, 235, 255};
    for (std::size_t row = 0; row < left.height; ++row) {
        const auto begin = static_cast<std::ptrdiff_t>(row * left.width);
        const auto middle = begin + column;
        const auto out = picture.pixels.begin();
        std::copy(left.pixels.begin() + begin, left.pixels.begin() + middle, out + begin);
        std::copy(right.pixels.begin() + middle, right.pixels.begin() + begin + left.width, out + middle);
        if (hasLine) {
            out[middle - 1] = kLine;
            out[middle] = kLine;
        }
    }
}

} // namespace cdr::viewer
