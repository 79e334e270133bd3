#include <cdr/depth/forecast.h>
#include <cdr/render/occluders/order_margin.h>
#include <cdr/shaders/occluders_shared.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cdr::render {

namespace {

constexpr std::size_t kNodes = shaders::kMarginNodes;
/// Margins are known at nodes alone, and what is between two of them may be a little worse than both.
constexpr double kBetweenNodes = 2.0;
/// A logarithm that is interpolated between vertices is off by this share of the distance at most (kLogWideSpan).
constexpr double kInterpolatedLog = 1e-4;

constexpr double kNever = std::numeric_limits<double>::infinity();

double interpolationOf(depth::Mapping mapping) {
    return mapping == depth::Mapping::log ? kInterpolatedLog : 0.0;
}

/// A forecast holds for small steps; this extends it to large ones. A step of depth is worth `step` at a distance, and
/// more farther away. It grows at most as it does where depth goes with 1 / distance.
double farthestBeyond(double distanceView, double step) {
    return step < distanceView ? step / (1.0 - step / distanceView) : kNever;
}

/// The technique as it is in a cascade that has a slice of the depth range to itself. There a float has no more bits than
/// D24, less one or two.
depth::Technique slicedTechnique(depth::Technique technique, const FrameView& view) {
    const bool isSliced = view.cascades.front().slice != DepthSlice{};
    if (isSliced && depth::traitsOf(technique.format).isFloat) {
        technique.format = depth::DepthFormat::d24;
    }
    return technique;
}

/// How many times coarser depth is by its slice.
double sliceLoss(const FrameView& view, depth::DepthFormat format, double distanceView) {
    for (const CascadeView& cascade : view.cascades) {
        if (distanceView <= cascade.clipRange.farView) {
            return cascade.slice == DepthSlice{} ? 1.0
                   : depth::traitsOf(format).isFloat
                       ? 4.0
                       : 1.0 / static_cast<double>(cascade.slice.max - cascade.slice.min);
        }
    }
    return kNever;
}

} // namespace

OrderMargin::OrderMargin(const depth::Technique& technique, const FrameView& view)
    : m_nearView(view.camera.nearView),
      m_nodesPerRatio(static_cast<double>(kNodes - 1) / std::log(view.camera.farView / m_nearView)) {
    const depth::Cascades cascades = view.ranges();
    const depth::Technique sliced = slicedTechnique(technique, view);
    const auto marginOf = [&](double distanceView) {
        const std::optional<depth::Forecast> forecast = depth::forecastIn(sliced, cascades, distanceView);
        return forecast ? farthestBeyond(distanceView, kBetweenNodes * forecast->guaranteedView() *
                                                           sliceLoss(view, technique.format, distanceView)) +
                              interpolationOf(technique.mapping) * distanceView
                        : kNever;
    };
    m_nodes.reserve(kNodes);
    for (std::size_t node = 0; node < kNodes; ++node) {
        m_nodes.push_back(marginOf(m_nearView * std::exp(static_cast<double>(node) / m_nodesPerRatio)));
    }
    // Between two nodes a cascade is coarsest at a node or at an end of its own. A bound belongs to the cascade before it.
    for (const depth::Cascade& cascade : cascades) {
        for (const double end : {std::nextafter(cascade.nearView, cascade.farView), cascade.farView}) {
            double& margin = m_nodes[nodeBefore(end)];
            margin = std::max(margin, marginOf(end));
        }
    }
}

double OrderMargin::placeOf(double distanceView) const {
    return std::log(distanceView / m_nearView) * m_nodesPerRatio;
}

std::size_t OrderMargin::nodeBefore(double distanceView) const {
    return static_cast<std::size_t>(std::clamp(placeOf(distanceView), 0.0, static_cast<double>(kNodes - 2)));
}

double OrderMargin::at(double distanceView) const {
    const double place = placeOf(distanceView);
    if (!(place >= 0.0) || place >= static_cast<double>(kNodes - 1)) {
        return kNever;
    }
    const auto node = static_cast<std::size_t>(place);
    return std::max(m_nodes[node], m_nodes[node + 1]);
}

} // namespace cdr::render
