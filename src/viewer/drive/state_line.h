#pragma once

#include <viewer/state/model/viewer_model.h>

#include <string>

namespace cdr::viewer {

/// What the viewer shows, one line of NAME=VALUE: what the script step `state` prints.
std::string stateLine(const ViewerModel& model);

} // namespace cdr::viewer
