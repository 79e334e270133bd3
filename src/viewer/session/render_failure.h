#pragma once

#include <viewer/state/requests/render_request.h>

namespace cdr::viewer {

/// Why something failed with the exception that is being handled. Rethrows one after which the viewer cannot go on.
RenderFailure explainFailure();

} // namespace cdr::viewer
