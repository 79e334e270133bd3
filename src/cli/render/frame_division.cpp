#include "frame_division.h"

#include <cdr/base/enum_names.h>

#include <runs/part_frames.h>
#include <runs/units.h>

#include <utility>

namespace cdr::cli {

namespace {

constexpr base::EnumNames<FrameDivision, 2> kNames{"division among ranks", {"frames", "cascades"}};

} // namespace

FrameDivision parseFrameDivision(std::string_view name) {
    return kNames.parse(name);
}

void makeFrames(ranks::Ranks& ranks, FrameDivision division, const std::vector<std::size_t>& frames,
                const FrameSteps& steps) {
    if (division == FrameDivision::frames) {
        runs::forEachUnit(
            ranks, frames.size(),
            [&](std::size_t unit) { return steps.describe(frames[unit], steps.draw(frames[unit])); },
            [&](std::size_t unit, output::Json made) { steps.take(frames[unit], std::move(made)); });
        return;
    }
    for (const std::size_t frame : frames) {
        render::Frame drawn = steps.draw(frame);
        std::size_t bytesSent = 0;
        runs::mergeParts(ranks, drawn, bytesSent);
        if (ranks.isFirst()) {
            steps.take(frame, steps.describe(frame, std::move(drawn)));
        }
    }
}

} // namespace cdr::cli
