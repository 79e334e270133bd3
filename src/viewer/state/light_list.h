#pragma once

#include <cdr/scene/scene_setup.h>

#include <span>
#include <string>
#include <vector>

namespace cdr::viewer {

/// A line for each of a file's lights: its type, its name and whether it moves. Beyond a dozen the last line says how many
/// more there are.
std::vector<std::string> lightLines(std::span<const scene::ListedLight> lights);

} // namespace cdr::viewer
