#pragma once

#include <cdr/render/frame_split.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/render_options.h>
#include <cdr/render/targets/targets.h>

#include <span>

namespace cdr::render {

/// Says of each frame who looks, and into which cascades the view is cut. Remembers the last frame's cut, so
/// that fitted cascades stay put.
class FrameCutter {
  public:
    /// @param targets that the cascades are drawn into. They must outlive the cutter.
    FrameCutter(const RenderOptions& options, const Targets& targets);

    /// A camera's frame, without cascades yet: enough to cull with.
    FrameView look(const scene::Camera& camera) const;

    /// Fills FrameView::cascades. base::InputError for an unusable split or range.
    /// @param visible opaque instances; read only where FrameSplit::needsVisible().
    /// @param occupied view distances of what else is drawn.
    void cut(FrameView& view, const visibility::VisibleCells& visible,
             std::span<const depth::Interval> occupied = {});

    /// The same with cascades that another split cut for this camera among others.
    void take(FrameView& view, const depth::Cascades& ranges) const;

    /// Finds the cascades, and remembers those of the frame before.
    FrameSplit& split() { return m_split; }

  private:
    const Targets& m_targets;
    depth::Mapping m_mapping;
    visibility::Detail m_detail;
    Focus m_focus;
    CascadePart m_part;
    vk::Extent2D m_extent;
    FrameSplit m_split;
};

} // namespace cdr::render
