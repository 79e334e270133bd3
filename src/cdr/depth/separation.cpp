#include <cdr/depth/separation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::depth {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Solves c/w - c/(w + gap) = step for the gap.
double hyperbolicGap(double c, double step, double distanceView) {
    const double left = c - distanceView * step;
    return left > 0.0 ? distanceView * distanceView * step / left : kInfinity;
}

/// The cascade that holds a distance; the last one's far plane counts as inside.
const Cascade* findCascade(const Cascades& cascades, double distanceView) {
    const auto found = std::find_if(cascades.begin(), cascades.end(),
                                    [&](const Cascade& cascade) { return cascade.contains(distanceView); });
    if (found != cascades.end()) {
        return &*found;
    }
    return !cascades.empty() && distanceView == cascades.back().farView ? &cascades.back() : nullptr;
}

/// Bisects to the distance in [low, high] where `reached` turns from `lowState` to its opposite.
double bisect(const std::function<bool(double)>& reached, double low, double high) {
    const bool lowState = reached(low);
    for (int i = 0; i < 200 && std::nextafter(low, high) < high; ++i) {
        const double middle = 0.5 * (low + high);
        (reached(middle) == lowState ? low : high) = middle;
    }
    return high;
}

} // namespace

double separationView(const DepthRange& range, DepthFormat format, double distanceView) {
    const double step = depthStep(format, zNdcAt(range, distanceView));
    if (isLog(range.mapping)) {
        return distanceView * std::expm1(step * std::log(*range.farView / range.nearView));
    }
    const double c = depthSlope(range, distanceView) * distanceView * distanceView;
    return hyperbolicGap(c, step, distanceView);
}

double separationView(Mapping mapping, const Cascades& cascades, DepthFormat format, double distanceView) {
    const Cascade* cascade = findCascade(cascades, distanceView);
    if (cascade == nullptr) {
        return kInfinity;
    }
    const FarEnd farEnd = cascade == &cascades.back() ? FarEnd::open : FarEnd::closed;
    return separationView(depthRange(mapping, *cascade, farEnd), format, distanceView);
}

double thesisSeparationView(Mapping mapping, const Cascades& cascades, int bits, double distanceView) {
    return tryThesisSeparationView(mapping, cascades, bits, distanceView).orThrow();
}

base::Result<double> tryThesisSeparationView(Mapping mapping, const Cascades& cascades, int bits,
                                             double distanceView) {
    if (mapping != Mapping::standard && mapping != Mapping::log) {
        return base::Refusal{"the thesis gives separations for standard and log alone"};
    }
    const Cascade* cascade = findCascade(cascades, distanceView);
    if (cascade == nullptr) {
        return kInfinity;
    }
    const double n = cascade->nearView;
    const double f = cascade->farView;
    if (mapping == Mapping::standard) {
        // Baker's form looks towards the camera: w - c / (c/w + step).
        const double c = f * n / (f - n);
        const double step = std::exp2(-bits);
        return distanceView * distanceView * step / (c + distanceView * step);
    }
    return distanceView * std::expm1(std::log(f / n) / (std::exp2(bits) - 1.0));
}

std::optional<Crossing> findCrossing(const std::function<double(double)>& curve, double separation,
                                     double nearView, double farView) {
    return findCrossings(curve, {&separation, 1}, nearView, farView).front();
}

std::vector<std::optional<Crossing>> findCrossings(const std::function<double(double)>& curve,
                                                   std::span<const double> separations, double nearView,
                                                   double farView) {
    // Fine enough to step into each cascade of the thesis. A thinner one may lie between two steps.
    constexpr int kSteps = 200'000;
    const auto grid = [&](int i) {
        return i == kSteps ? farView
                           : nearView * std::pow(farView / nearView, static_cast<double>(i) / kSteps);
    };
    struct Steps {
        int first = -1; ///< the first that reaches the separation
        int last = -1;  ///< the last below it
    };
    std::vector<Steps> found(separations.size());
    for (int i = 0; i <= kSteps; ++i) {
        const double here = curve(grid(i));
        for (std::size_t s = 0; s < separations.size(); ++s) {
            const bool isReached = here >= separations[s];
            found[s].first = isReached && found[s].first < 0 ? i : found[s].first;
            found[s].last = isReached ? found[s].last : i;
        }
    }
    std::vector<std::optional<Crossing>> crossings(separations.size());
    for (std::size_t s = 0; s < separations.size(); ++s) {
        const auto& [first, last] = found[s];
        if (first < 0) {
            continue;
        }
        const auto reached = [&](double w) { return curve(w) >= separations[s]; };
        crossings[s] = Crossing{
            .reachedFirstView = first == 0 ? nearView : bisect(reached, grid(first - 1), grid(first)),
            .heldLastView = last < 0         ? nearView
                            : last == kSteps ? farView
                                             : bisect(reached, grid(last), grid(last + 1))};
    }
    return crossings;
}

} // namespace cdr::depth
