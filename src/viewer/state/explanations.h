#pragma once

#include "view_settings.h"

#include <string_view>

namespace cdr::viewer {

// One plain sentence or two for each thing there is to choose: what it does, and what it is good and bad at.

std::string_view explanationOf(const depth::Split& split);
std::string_view explanationOf(depth::DepthFormat format);
std::string_view explanationOf(render::Submission submission);
std::string_view explanationOf(render::Batching batching);
std::string_view explanationOf(render::Snapping snapping);
std::string_view explanationOf(visibility::DetailMode detail);
std::string_view explanationOf(render::Translucency translucency);
std::string_view explanationOf(render::ShadowMethod shadows);
std::string_view explanationOf(render::Antialias antialias);
std::string_view explanationOf(render::ToneMap toneMap);
std::string_view explanationOf(const render::Occlusion& occlusion);
std::string_view explanationOf(const render::Fog& fog);
std::string_view explanationOf(const render::Focus& focus);
std::string_view explanationOf(ViewKind view);
/// Of the worker threads.
std::string_view explainThreads();

} // namespace cdr::viewer
