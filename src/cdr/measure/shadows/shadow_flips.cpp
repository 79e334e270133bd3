#include <cdr/base/error.h>
#include <cdr/measure/shadows/shadow_flips.h>

namespace cdr::measure {

namespace {

template <typename Pixel>
void requireSizeOf(const ShadowImage& truth, const image::Raster<Pixel>& other) {
    if (other.width != truth.width || other.height != truth.height) {
        throw base::InputError("shadow flips: the frames differ in size");
    }
}

} // namespace

FlipCount countShadowFlips(const ShadowFrame& before, const ShadowFrame& after) {
    requireSizeOf(before.truth, after.truth);
    requireSizeOf(before.truth, before.light.reached);
    requireSizeOf(before.truth, after.light.reached);
    FlipCount count;
    for (std::uint32_t y = 0; y < before.truth.height; ++y) {
        for (std::uint32_t x = 0; x < before.truth.width; ++x) {
            const bool isSteady = before.truth.at(x, y) == after.truth.at(x, y) &&
                                  isInnerShadow(before.truth, x, y) && isInnerShadow(after.truth, x, y);
            if (isSteady) {
                ++count.compared;
                count.flips += before.light.reaches(x, y) != after.light.reaches(x, y);
            }
        }
    }
    return count;
}

} // namespace cdr::measure
