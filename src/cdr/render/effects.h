#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// How stairs along edges are smoothed.
enum class Antialias : std::uint8_t {
    none,
    edges, ///< after shading, along edges of brightness (FXAA, Lottes 2009)
};

inline constexpr std::array kAntialiases{Antialias::none, Antialias::edges};

/// "none" or "edges".
std::string_view nameOf(Antialias antialias);
/// base::InputError with a suggestion for an unknown name.
Antialias parseAntialias(std::string_view name);

/// What makes a picture look finished, and measurements do without. None of it knows the technique: effects
/// read the one metric distance of the G-buffer.
struct Effects {
    Antialias antialias = Antialias::none;

    bool operator==(const Effects&) const = default;
};

} // namespace cdr::render
