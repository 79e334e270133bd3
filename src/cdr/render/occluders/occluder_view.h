#pragma once

#include <cdr/render/frame_view.h>

namespace cdr::render {

/// A frame as occluders are drawn for it. Cascades are cut and placed in the picture as in the frame itself, so occluders
/// cover the same pixels. But all are in one depth buffer of near / view distance, with the near plane of the camera.
FrameView occluderView(const FrameView& view);

} // namespace cdr::render
