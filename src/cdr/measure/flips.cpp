#include <cdr/base/error.h>
#include <cdr/measure/flips.h>
#include <cdr/measure/wrong_pixels.h>

namespace cdr::measure {

std::uint64_t countFlips(const IdFrame& before, const IdFrame& after) {
    const std::size_t pixels = before.ids.pixels.size();
    if (after.ids.pixels.size() != pixels || before.truth.pixels.size() != pixels ||
        after.truth.pixels.size() != pixels) {
        throw base::InputError("flips: the two frames differ in size");
    }
    const auto innerBefore = innerMask(before.truth);
    const auto innerAfter = innerMask(after.truth);
    std::uint64_t flips = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const bool stays = innerBefore.pixels[i] != 0 && innerAfter.pixels[i] != 0 &&
                           before.truth.pixels[i].id == after.truth.pixels[i].id;
        flips += stays && before.ids.pixels[i] != after.ids.pixels[i] ? 1 : 0;
    }
    return flips;
}

} // namespace cdr::measure
