#include <cdr/render/occluders/occluder_view.h>

namespace cdr::render {

FrameView occluderView(const FrameView& view) {
    FrameView occluders = view;
    for (CascadeView& cascade : occluders.cascades) {
        // Clip z is the offset, and clip w the view distance.
        cascade.terms.scale = 0.0;
        cascade.terms.offset = view.camera.nearView;
        cascade.slice = {};
    }
    return occluders;
}

} // namespace cdr::render
