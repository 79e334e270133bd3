#pragma once

/// @file
/// @errors None: neither that there is a frame nor that all have one size is checked.

#include <cdr/base/export.h>
#include <cdr/render/frame.h>

#include <cstdint>
#include <span>

namespace cdr::render {

/// The frames of a ViewsRenderer as one, its pictures beside each other in order, which Frame::views tells apart. Counts
/// and times are sums, except that executeMs is the longest.
/// @param camera that the joined frame says it is of.
/// @param shift in pixels: by how much in all the pictures of two eyes are moved towards each other.
CDR_EXPORT Frame joinedFrame(std::span<const Frame> views, const scene::Camera& camera,
                             std::uint32_t shift = 0);

} // namespace cdr::render
