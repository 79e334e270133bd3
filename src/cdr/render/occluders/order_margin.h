#pragma once

#include <cdr/depth/technique.h>
#include <cdr/render/frame_view.h>

#include <vector>

namespace cdr::render {

/// By how much something must be farther than a surface to lose against it in a technique's depth buffer for certain.
/// A buffer that is too coarse for two surfaces may show the farther one, so that one is not hidden.
class OrderMargin {
  public:
    /// For the cascades of a frame.
    OrderMargin(const depth::Technique& technique, const FrameView& view);

    /// In scene units, at a surface's view distance; infinity outside the cascades.
    double at(double distanceView) const;

  private:
    double m_nearView;
    double m_nodesPerRatio;      ///< nodes over a ratio of e
    std::vector<double> m_nodes; ///< at distances of one ratio to the next
};

} // namespace cdr::render
