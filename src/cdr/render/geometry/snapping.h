#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// How vertices get to the sub-pixels that devices round them to. Rounded across the picture alone, a vertex keeps its depth,
/// and its triangle leaves its plane. Then the nearer of two slanted surfaces is right only for gaps above
/// depth::snapGapView().
enum class Snapping : std::uint8_t {
    byDevice, ///< the device rounds them
    /// The vertex shader moves them to the middle of a sub-pixel first, in the plane of their facet: depth stays that of the
    /// plane. For meshes of facets: each triangle has one colour and one normal, its own. Other meshes are drawn as by
    /// `byDevice`. It needs a device that has the sub-pixel bits that it tells. Triangles that are cut at a cascade's planes get
    /// corners that only the device rounds. So are cascades that a focus draws in fewer pixels. Not for blended surfaces, nor
    /// with a visibility buffer.
    inPlane,
};

/// All of them.
inline constexpr std::array kSnappings{Snapping::byDevice, Snapping::inPlane};

/// "by-device" or "in-plane".
CDR_EXPORT std::string_view nameOf(Snapping snapping);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Snapping parseSnapping(std::string_view name);

} // namespace cdr::render
