#pragma once

#include <cdr/render/renderer.h>

#include <string_view>

namespace cdr::viewer {

/// What a picture is finished with, whatever its technique.
struct Finish {
    visibility::Detail detail{};
    render::TranslucencyOptions translucency{};
    render::Shadows shadows{};
    render::Effects effects{};
    render::Focus focus{};

    bool operator==(const Finish&) const = default;
};

/// Puts it into the options of a renderer. Occlusion per cascade is for layered targets, so with
/// others it is worked out over the whole picture. A focus is for `layers` alone, so with others there is
/// none. There are no shadows with a focus, nor where levels of detail cast none.
void apply(const Finish& finish, render::RenderOptions& options);
/// Whether the shadows that are chosen are drawn with such targets, beside what else is chosen.
bool castsShadows(const Finish& finish, render::TargetsKind targets);

std::string_view explanationOf(visibility::DetailMode detail);
std::string_view explanationOf(render::Translucency translucency);
std::string_view explanationOf(render::ShadowMethod shadows);
std::string_view explanationOf(render::Antialias antialias);
std::string_view explanationOf(render::ToneMap toneMap);
std::string_view explanationOf(const render::Occlusion& occlusion);
std::string_view explanationOf(const render::Fog& fog);
std::string_view explanationOf(const render::Focus& focus);

} // namespace cdr::viewer
