#pragma once

#include <cdr/scene/scene.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::scenes {

/// How generated scenes look that the thesis has in one grey.
enum class Colours : std::uint8_t {
    thesis, ///< one grey, lit from within: what experiments measure
    bright, ///< a colour for each object, lit like a clear day: what people look at
};
inline constexpr std::array kColours{Colours::thesis, Colours::bright};

/// "thesis" or "bright".
std::string_view nameOf(Colours colours);
/// base::InputError with a suggestion for an unknown name.
Colours parseColours(std::string_view name);

/// Gives a scene that isGreyInThesis() other colours and light. Objects, their order and their depths stay. Any other scene
/// keeps the colours of its own.
/// @param name as scenes::openScene() took it.
void paint(scene::Scene& scene, std::string_view name, Colours colours);

} // namespace cdr::scenes
