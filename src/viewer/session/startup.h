#pragma once

#include "arguments.h"

#include <viewer/state/model/viewer_model.h>
#include <viewer/window/window.h>

#include <filesystem>
#include <string>

namespace cdr::viewer {

/// What the command line asks to see first. base::InputError says what cannot be.
ViewerModel initialModel(const Arguments& arguments);

/// The window's size in pixels. Where a line that renders a picture is shown, it is that of the picture, both eyes together.
FirstSize firstSize(const Arguments& arguments, const ViewSettings& settings);

/// STEM-0001EXTENSION in the current folder, or the first number above that is free.
std::filesystem::path freeName(const std::string& stem, const std::string& extension);

} // namespace cdr::viewer
