#pragma once

#include <cdr/depth/technique.h>
#include <cdr/render/frame_view.h>

#include <cstddef>
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

    /// The same at distances of one ratio to the next, from the camera's near plane on; between two of them the larger
    /// holds.
    const std::vector<double>& nodes() const { return m_nodes; }
    double nodesPerRatio() const { return m_nodesPerRatio; } ///< over a ratio of e

  private:
    /// Nodes from the near plane to there.
    double placeOf(double distanceView) const;
    /// The one at a distance or before it, which has one after it.
    std::size_t nodeBefore(double distanceView) const;

    double m_nearView;
    double m_nodesPerRatio;
    std::vector<double> m_nodes;
};

} // namespace cdr::render
