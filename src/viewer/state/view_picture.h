#pragma once

#include "view_settings.h"

#include <cdr/image/image.h>
#include <cdr/render/frame.h>

namespace cdr::viewer {

/// A frame as shaded, cascades, distance or ids, opaque, into a picture that is resized as needed. One of the
/// frame's size is reused. base::InputError for a view that needsReference().
///
/// Distances run from white at the nearest surface to dark at the farthest, by their logarithm. Ids get
/// colours that neighbours do not share; background is black in both.
void paintView(const render::Frame& frame, ViewKind view, image::ImageRgba8& picture);

/// The colour of a cascade in the cascades view, and of its row in a list.
image::Rgba8 cascadeColor(std::size_t cascade);
/// The colour of an object in the ids view; black for 0.
image::Rgba8 idColor(std::uint32_t id);

} // namespace cdr::viewer
