#include <cdr/image/same_size.h>
#include <cdr/measure/shadows/shadow_flips.h>

namespace cdr::measure {

FlipCount countShadowFlips(const ShadowFrame& before, const ShadowFrame& after) {
    image::requireSameSize(before.truth, after.truth, "shadow flips");
    image::requireSameSize(before.truth, before.light.reached, "shadow flips");
    image::requireSameSize(before.truth, after.light.reached, "shadow flips");
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
