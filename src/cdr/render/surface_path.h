#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// What the geometry pass keeps of a surface until it is shaded. Pictures differ by roundings alone.
enum class SurfacePath : std::uint8_t {
    gbuffer,    ///< albedo, normal, distance and id: 16 bytes a pixel
    visibility, ///< which facet: 4 bytes a pixel, and a record per facet that the CPU writes
    /// Nothing: facets are lit while they are drawn, into the picture. A special case, not deferred: matt surfaces under
    /// at most two lights, without effects, drawn to targets `single` or `one-pass`. Whoever asks for the G-buffer has the
    /// facets drawn once more, as for `visibility`.
    lit,
};

/// All of them.
inline constexpr std::array kSurfacePaths{SurfacePath::gbuffer, SurfacePath::visibility, SurfacePath::lit};

/// "gbuffer", "visibility" or "lit".
CDR_EXPORT std::string_view nameOf(SurfacePath path);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT SurfacePath parseSurfacePath(std::string_view name);

} // namespace cdr::render
