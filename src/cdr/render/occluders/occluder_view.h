#pragma once

#include <cdr/render/frame_view.h>

namespace cdr::render {

/// A frame as occluders are drawn for it: the same cascades, cut and placed in the picture as ever, so that they cover
/// the pixels that they will cover. But all in one depth buffer, of near / view distance, the near plane of the camera.
FrameView occluderView(const FrameView& view);

} // namespace cdr::render
