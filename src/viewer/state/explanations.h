#pragma once

#include "view_settings.h"

#include <string_view>

namespace cdr::viewer {

// One plain sentence or two for each thing there is to choose: what it does, and what it is good and bad at.

std::string_view explain(depth::Mapping mapping);
std::string_view explain(const depth::Split& split);
std::string_view explain(depth::DepthFormat format);
std::string_view explain(render::TargetsKind targets);
std::string_view explain(render::Submission submission);
std::string_view explain(render::Batching batching);
std::string_view explain(render::Snapping snapping);
std::string_view explain(ViewKind view);
/// Of the worker threads.
std::string_view explainThreads();

} // namespace cdr::viewer
