#pragma once

#include "render_request.h"

#include <optional>

namespace cdr::viewer {

/// What the viewer wants to see now, and how it moves.
struct Wanted {
    RenderRequest request;       ///< what to show; what decide() sets is ignored
    bool isFlying = false;       ///< the camera or the scene moves by itself or by hand
    bool rendersAlways = false;  ///< also where nothing changes
    bool surfacesAreDue = false; ///< while it moves, picking has waited long enough for surfaces to read
    bool isThreadReady = false;  ///< the render thread has taken the request before
};

/// The request that follows: what is wanted, with what to copy and count. None where the previous one has it, or where what it
/// lacks can wait until the thread is ready. A picture that changes does not wait: a newer request takes an older one's place.
/// @param previous null before the first.
std::optional<RenderRequest> decide(const RenderRequest* previous, Wanted wanted);

/// Whether a picture at rest goes on changing: flips that it shows have to fade.
/// @param shown null before the first.
bool fades(const RenderResult* shown);

} // namespace cdr::viewer
