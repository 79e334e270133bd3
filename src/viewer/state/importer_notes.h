#pragma once

#include <cdr/scene/scene_setup.h>

#include <string>
#include <vector>

namespace cdr::viewer {

/// What of a file is ignored in the viewer, a line each. The viewer plays animations, so no line is about these.
std::vector<std::string> importerNotes(const scene::OpenedScene& scene);

} // namespace cdr::viewer
