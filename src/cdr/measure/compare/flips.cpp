#include <cdr/image/same_size.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <utility>

namespace cdr::measure {

FlipCount& FlipCount::operator+=(const FlipCount& other) {
    flips += other.flips;
    compared += other.compared;
    return *this;
}

image::Raster<std::uint8_t> steadyMask(const TruthImage& before,
                                       const image::Raster<std::uint8_t>& innerBefore,
                                       const TruthImage& after,
                                       const image::Raster<std::uint8_t>& innerAfter) {
    image::requireSameSize(before, innerBefore, "flips");
    image::requireSameSize(before, after, "flips");
    image::requireSameSize(before, innerAfter, "flips");
    image::Raster<std::uint8_t> steady(before.width, before.height);
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        const bool inner = innerBefore.pixels[i] != 0 && innerAfter.pixels[i] != 0;
        steady.pixels[i] = inner && before.pixels[i].id == after.pixels[i].id ? 1 : 0;
    }
    return steady;
}

void SceneTruth::add(TruthImage next) {
    image::Raster<std::uint8_t> nextInner = innerMask(next);
    steady = truth.pixels.empty() ? std::nullopt : std::optional(steadyMask(truth, inner, next, nextInner));
    truth = std::move(next);
    inner = std::move(nextInner);
}

FlipCount countFlips(const image::ImageU32& idsBefore, const image::ImageU32& idsAfter,
                     const image::Raster<std::uint8_t>& steady) {
    image::requireSameSize(idsBefore, idsAfter, "flips");
    image::requireSameSize(idsBefore, steady, "flips");
    FlipCount count;
    for (std::size_t i = 0; i < steady.pixels.size(); ++i) {
        const std::uint64_t stays = steady.pixels[i];
        count.compared += stays;
        count.flips += idsBefore.pixels[i] != idsAfter.pixels[i] ? stays : 0;
    }
    return count;
}

FlipCount countFlips(const IdFrame& before, const IdFrame& after) {
    image::requireSameSize(before.truth, after.truth, "flips");
    return countFlips(before.ids, after.ids,
                      steadyMask(before.truth, innerMask(before.truth), after.truth, innerMask(after.truth)));
}

} // namespace cdr::measure
