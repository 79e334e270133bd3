#include <cdr/image/same_size.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <algorithm>
#include <cstddef>

namespace cdr::measure {

namespace {

constexpr image::Rgba8 kWrong{255, 0, 0, 255};
constexpr image::Rgba8 kWrongOnEdge{255, 165, 0, 255};

/// One row: `above`, `row` and `below` are ids of `width` pixels. Without branches, so that compilers use
/// vectors.
void innerRow(const std::uint32_t* above, const std::uint32_t* row, const std::uint32_t* below,
              std::uint32_t width, std::uint8_t* inner) {
    const auto columnShares = [&](std::uint32_t x, std::uint32_t id) {
        return (above[x] ^ id) | (row[x] ^ id) | (below[x] ^ id);
    };
    for (std::uint32_t x = 1; x + 1 < width; ++x) {
        const std::uint32_t id = row[x];
        const std::uint32_t others = columnShares(x - 1, id) | columnShares(x, id) | columnShares(x + 1, id);
        inner[x] = static_cast<std::uint8_t>((others == 0) & (id != 0));
    }
}

} // namespace

WrongPixels& WrongPixels::operator+=(const WrongPixels& other) {
    pixels += other.pixels;
    wrong += other.wrong;
    edgeWrong += other.edgeWrong;
    overlapPixels += other.overlapPixels;
    overlapWrong += other.overlapWrong;
    return *this;
}

void innerMask(const image::ImageU32& ids, image::Raster<std::uint8_t>& mask) {
    if (mask.width != ids.width || mask.height != ids.height) {
        mask = image::Raster<std::uint8_t>(ids.width, ids.height);
    }
    std::fill(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{0});
    for (std::uint32_t y = 1; y + 1 < ids.height; ++y) {
        innerRow(&ids.at(0, y - 1), &ids.at(0, y), &ids.at(0, y + 1), ids.width, &mask.at(0, y));
    }
}

image::Raster<std::uint8_t> innerMask(const TruthImage& truth) {
    image::ImageU32 ids(truth.width, truth.height);
    std::ranges::transform(truth.pixels, ids.pixels.begin(), &TruthPixel::id);
    image::Raster<std::uint8_t> mask(truth.width, truth.height);
    innerMask(ids, mask);
    for (std::size_t i = 0; i < truth.doubtful.pixels.size(); ++i) {
        mask.pixels[i] = truth.doubtful.pixels[i] != 0 ? std::uint8_t{0} : mask.pixels[i];
    }
    return mask;
}

WrongPixels countWrong(const image::ImageU32& ids, const TruthImage& truth) {
    return countWrong(ids, truth, innerMask(truth));
}

WrongPixels countWrong(const image::ImageU32& ids, const TruthImage& truth,
                       const image::Raster<std::uint8_t>& inner) {
    image::requireSameSize(ids, truth, "wrong pixels: the id image's size");
    image::requireSameSize(inner, truth, "wrong pixels: the mask's size");
    WrongPixels count;
    for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
        const bool wrong = ids.pixels[i] != truth.pixels[i].id;
        if (!inner.pixels[i]) {
            count.edgeWrong += wrong;
            continue;
        }
        ++count.pixels;
        count.wrong += wrong;
        if (truth.pixels[i].secondId != 0) {
            ++count.overlapPixels;
            count.overlapWrong += wrong;
        }
    }
    return count;
}

image::ImageRgba8 heatMap(const image::ImageU32& ids, const TruthImage& truth,
                          const image::ImageRgba8& picture) {
    image::requireSameSize(ids, truth, "heat map: the id image's size");
    image::requireSameSize(picture, truth, "heat map: the picture's size");
    const image::Raster<std::uint8_t> inner = innerMask(truth);
    image::ImageRgba8 map(truth.width, truth.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        if (ids.pixels[i] == truth.pixels[i].id) {
            map.pixels[i] = dimmed(picture.pixels[i]);
        } else {
            map.pixels[i] = inner.pixels[i] ? kWrong : kWrongOnEdge;
        }
    }
    return map;
}

} // namespace cdr::measure
