#pragma once

#include <cdr/render/render_options.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <options/cli_app.h>

#include <cstdint>

namespace cdr::options {

/// Most MiB that --translucency-memory takes: 4 TiB.
inline constexpr std::uint64_t kMaxTranslucencyMiB = std::uint64_t{1} << 22u;

/// Adds the options of effects, focus, shadows and translucency, which go into `options`, and --light, which goes into
/// `choice`. What cannot be parsed or drawn ends with base::InputError, which names the option or the value.
/// @param options @param choice must live as long as the command.
void addEffectOptions(CLI::App& command, render::RenderOptions& options, scene::GltfChoice& choice);

} // namespace cdr::options
