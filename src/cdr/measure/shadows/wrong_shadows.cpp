#include <cdr/image/same_size.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/shadows/wrong_shadows.h>

namespace cdr::measure {

namespace {

constexpr image::Rgba8 kMissing{255, 0, 0, 255};
constexpr image::Rgba8 kInvented{0, 114, 255, 255};
constexpr image::Rgba8 kWrongAtEdge{255, 165, 0, 255};

enum class Verdict : std::uint8_t { uncounted, right, wrong, edgeRight, edgeWrong };

bool facesLight(const ShadowPixel& pixel) {
    return pixel.reach == Reach::reached || pixel.reach == Reach::shadowed;
}

Verdict verdictAt(const RenderedLight& light, const ShadowImage& truth, std::uint32_t x, std::uint32_t y) {
    if (!facesLight(truth.at(x, y))) {
        return Verdict::uncounted;
    }
    const bool isRight = light.reaches(x, y) == (truth.at(x, y).reach == Reach::reached);
    if (isInnerShadow(truth, x, y)) {
        return isRight ? Verdict::right : Verdict::wrong;
    }
    return isRight ? Verdict::edgeRight : Verdict::edgeWrong;
}

template <typename Take>
void forVerdicts(const RenderedLight& light, const ShadowImage& truth, const Take& take) {
    image::requireSameSize(light.reached, truth, "shadows");
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            take(x, y, verdictAt(light, truth, x, y));
        }
    }
}

} // namespace

bool isInnerShadow(const ShadowImage& truth, std::uint32_t x, std::uint32_t y) {
    if (x == 0 || y == 0 || x + 1 >= truth.width || y + 1 >= truth.height || !facesLight(truth.at(x, y)) ||
        truth.at(x, y).isDoubtful) {
        return false;
    }
    for (std::uint32_t i = 0; i < 9; ++i) {
        if (truth.at(x - 1 + i % 3, y - 1 + i / 3) != truth.at(x, y)) {
            return false;
        }
    }
    return true;
}

WrongShadows& WrongShadows::operator+=(const WrongShadows& other) {
    pixels += other.pixels;
    shadowed += other.shadowed;
    wrong += other.wrong;
    edgeWrong += other.edgeWrong;
    return *this;
}

WrongShadows countWrongShadows(const RenderedLight& light, const ShadowImage& truth) {
    WrongShadows count;
    forVerdicts(light, truth, [&](std::uint32_t x, std::uint32_t y, Verdict verdict) {
        const bool isInside = verdict == Verdict::right || verdict == Verdict::wrong;
        count.pixels += isInside;
        count.shadowed += isInside && truth.at(x, y).reach == Reach::shadowed;
        count.wrong += verdict == Verdict::wrong;
        count.edgeWrong += verdict == Verdict::edgeWrong;
    });
    return count;
}

image::ImageRgba8 shadowHeatMap(const RenderedLight& light, const ShadowImage& truth,
                                const image::ImageRgba8& picture) {
    image::requireSameSize(picture, truth, "shadows: the picture's size");
    image::ImageRgba8 map(truth.width, truth.height);
    forVerdicts(light, truth, [&](std::uint32_t x, std::uint32_t y, Verdict verdict) {
        map.at(x, y) = verdict == Verdict::wrong       ? (light.reaches(x, y) ? kMissing : kInvented)
                       : verdict == Verdict::edgeWrong ? kWrongAtEdge
                                                       : dimmed(picture.at(x, y));
    });
    return map;
}

} // namespace cdr::measure
