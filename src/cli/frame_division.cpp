#include "frame_division.h"

#include <cdr/base/enum_names.h>
#include <experiments/part_frames.h>
#include <experiments/units.h>

#include <utility>

namespace cdr::cli {

namespace {

constexpr base::EnumNames<FrameDivision, 2> kNames{"division among ranks", {"frames", "cascades"}};

} // namespace

FrameDivision parseFrameDivision(std::string_view name) {
    return kNames.parse(name);
}

void makeFrames(ranks::Ranks& ranks, FrameDivision division, std::size_t count, const FrameSteps& steps) {
    if (division == FrameDivision::frames) {
        experiments::forEachUnit(
            ranks, count, [&](std::size_t frame) { return steps.describe(frame, steps.draw(frame)); },
            steps.take);
        return;
    }
    for (std::size_t frame = 0; frame < count; ++frame) {
        render::Frame drawn = steps.draw(frame);
        std::size_t bytesSent = 0;
        experiments::mergeParts(ranks, drawn, bytesSent);
        if (ranks.isFirst()) {
            steps.take(frame, steps.describe(frame, std::move(drawn)));
        }
    }
}

} // namespace cdr::cli
