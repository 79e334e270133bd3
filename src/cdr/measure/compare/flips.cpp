#include <cdr/base/error.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>

namespace cdr::measure {

namespace {

template <typename A, typename B>
void requireSameSize(const image::Raster<A>& a, const image::Raster<B>& b) {
    if (a.width != b.width || a.height != b.height) {
        throw base::InputError("flips: the two frames differ in size");
    }
}

} // namespace

FlipCount& FlipCount::operator+=(const FlipCount& other) {
    flips += other.flips;
    compared += other.compared;
    return *this;
}

image::Raster<std::uint8_t> steadyMask(const TruthImage& before,
                                       const image::Raster<std::uint8_t>& innerBefore,
                                       const TruthImage& after,
                                       const image::Raster<std::uint8_t>& innerAfter) {
    requireSameSize(before, innerBefore);
    requireSameSize(before, after);
    requireSameSize(before, innerAfter);
    image::Raster<std::uint8_t> steady(before.width, before.height);
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        const bool inner = innerBefore.pixels[i] != 0 && innerAfter.pixels[i] != 0;
        steady.pixels[i] = inner && before.pixels[i].id == after.pixels[i].id ? 1 : 0;
    }
    return steady;
}

FlipCount countFlips(const image::ImageU32& idsBefore, const image::ImageU32& idsAfter,
                     const image::Raster<std::uint8_t>& steady) {
    requireSameSize(idsBefore, idsAfter);
    requireSameSize(idsBefore, steady);
    FlipCount count;
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        const std::uint64_t stays = steady.pixels[i];
        count.compared += stays;
        count.flips += idsBefore.pixels[i] != idsAfter.pixels[i] ? stays : 0;
    }
    return count;
}

FlipCount countFlips(const IdFrame& before, const IdFrame& after) {
    requireSameSize(before.truth, after.truth);
    return countFlips(before.ids, after.ids,
                      steadyMask(before.truth, innerMask(before.truth), after.truth, innerMask(after.truth)));
}

} // namespace cdr::measure
