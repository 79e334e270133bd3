#pragma once

namespace cdr::viewer {

/// Dark, quiet, and the same colours as the report's page.
/// @param scale of every distance.
void applyStyle(float scale);

} // namespace cdr::viewer
