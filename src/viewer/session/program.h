#pragma once

#include "arguments.h"

#include <functional>

namespace cdr::viewer {

class Player;

/// Runs the viewer until it closes. base::RunError when the validation layer reported anything, its end included.
/// @param player plays input if not null; must outlive the call.
void runViewer(const Arguments& arguments, Player* player = nullptr);

/// The exit status of `body`. What it throws becomes one line on standard error and a status for main().
/// @param program the name that begins the line.
int exitStatusOf(const char* program, const std::function<int()>& body);

} // namespace cdr::viewer
