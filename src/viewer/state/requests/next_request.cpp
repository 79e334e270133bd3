#include "next_request.h"

#include <algorithm>

namespace cdr::viewer {

namespace {

bool showTheSame(const RenderRequest& a, const RenderRequest& b) {
    return a.camera == b.camera && a.frame == b.frame && a.settings == b.settings && a.extent == b.extent;
}

bool lacks(const RenderRequest& previous, const RenderRequest& next) {
    return (next.wantsSurfaces && !previous.wantsSurfaces) || (next.countsWrong && !previous.countsWrong) ||
           (next.isAtRest && !previous.isAtRest);
}

} // namespace

std::optional<RenderRequest> decide(const RenderRequest* previous, Wanted wanted) {
    RenderRequest& next = wanted.request;
    const bool isStill = !wanted.isFlying && !wanted.rendersAlways;
    next.wantsSurfaces = isStill || wanted.surfacesAreDue;
    next.countsWrong = isStill;
    if (previous == nullptr || !showTheSame(*previous, next)) {
        next.isAtRest = false;
        return next;
    }
    next.isAtRest = !wanted.isFlying && remembersFrames(next.settings);
    const bool isWorthAsking = wanted.rendersAlways || lacks(*previous, next);
    return isWorthAsking && wanted.isThreadReady ? std::optional(next) : std::nullopt;
}

bool fades(const RenderResult* shown) {
    return shown != nullptr &&
           std::ranges::any_of(shown->sides, [](const SideResult& side) { return side.flippedPixels > 0; });
}

} // namespace cdr::viewer
