#pragma once

#include "arguments.h"
#include "viewer_model.h"

#include <viewer/drive/script_player.h>

#include <filesystem>
#include <optional>
#include <string>

namespace cdr::viewer {

/// What the command line asks to see first. base::InputError says what cannot be.
ViewerModel initialModel(const Arguments& arguments);

/// Of the window, screen coordinates. base::InputError unless it is WIDTHxHEIGHT.
PictureExtent windowSize(const Arguments& arguments);

/// The script named, if any. base::InputError for one that cannot be read.
std::optional<ScriptPlayer> loadScript(const Arguments& arguments);

/// STEM-0001EXTENSION in the current folder, or the first number above that is free.
std::filesystem::path freeName(const std::string& stem, const std::string& extension);

} // namespace cdr::viewer
