#include <cdr/depth/cascade_plan.h>
#include <cdr/depth/fitted_split.h>

#include <algorithm>

namespace cdr::depth {

namespace {

constexpr double kMargin = 1.0 / 128.0;

/// Every step is a larger share of its distance, so a finer target changes nothing. It is above 0, so that a
/// target can be relaxed by a factor.
constexpr double kMinShare = 1e-30;

/// Turning a float32 vertex loses about this share of the object's size, a few roundings of its radius.
constexpr double kVertexRounding = 0x1p-22;

StepTarget targetOf(const SplitFitted& split, const SplitContext& view, double thinnestView) {
    StepTarget target{.leastUnitsView = kVertexRounding * thinnestView,
                      .leastShareView = distanceRounding(view.model.mapping)};
    if (split.unit == SplitFitted::Unit::pixels) {
        target.shareView = std::max(split.target * view.footprintSlope, kMinShare);
    } else {
        target.unitsView = std::max(split.target, kMinShare * view.nearView);
    }
    return target;
}

/// The plan for a target that was relaxed until it is met. One cascade over everything where there is none.
Cascades planOrOne(const StepModel& model, const StepTarget& target, const std::vector<Interval>& occupied,
                   std::size_t most) {
    return planCascades(model, target, occupied, most)
        .value_or(Cascades{{occupied.front().nearView, occupied.back().farView}});
}

/// The plan for a target, or for one wider or finer by the slack if that keeps the previous count.
Cascades planNear(const StepModel& model, const StepTarget& target, const std::vector<Interval>& occupied,
                  std::size_t most, std::size_t previousCount) {
    Cascades plan = planOrOne(model, target, occupied, most);
    if (previousCount == 0 || previousCount == plan.size()) {
        return plan;
    }
    const double factor = previousCount < plan.size() ? 1.0 + kFitSlack : 1.0 / (1.0 + kFitSlack);
    std::optional<Cascades> other = planCascades(model, target.scaled(factor), occupied, most);
    return other && other->size() == previousCount ? *other : plan;
}

bool touches(std::span<const Cascade> cascades, std::size_t boundary) {
    return boundary > 0 && boundary < cascades.size() &&
           cascades[boundary - 1].farView == cascades[boundary].nearView;
}

/// What placing the bounds of one fit needs.
struct Fit {
    const SplitContext& view;
    const StepTarget& target;
    const Cascades& plan; ///< tight

    /// How far ends may move out.
    struct Give {
        double thickness; ///< share of the cascade's thickness, or before it of its near distance if less
        double rounding;  ///< multiple of endRounding()
        double gap;       ///< share of the gap to the neighbour at most
    };

    double gapBefore(std::size_t i) const { return plan[i].nearView - plan[i - 1].farView; }

    /// The cascade with its clean ends moved out; a cut has no gap to move into.
    Cascade widened(std::size_t i, const Give& give) const {
        const Cascade& tight = plan[i];
        const double thickness = tight.farView - tight.nearView;
        const double rounding = give.rounding * endRounding(view.model.mapping);
        const double before =
            give.thickness * std::min(thickness, tight.nearView) + rounding * tight.nearView;
        const double after = give.thickness * thickness + rounding * tight.farView;
        const double roomBefore = i == 0 ? tight.nearView - view.nearView : give.gap * gapBefore(i);
        const double roomAfter =
            i + 1 == plan.size() ? view.farView - tight.farView : give.gap * gapBefore(i + 1);
        return {tight.nearView - std::min(before, roomBefore), tight.farView + std::min(after, roomAfter)};
    }

    bool meets(const Cascade& cascade, double slack) const {
        return worstStepShare(view.model, target, cascade) <= 1.0 + slack;
    }
};

constexpr Fit::Give kRoomy{.thickness = kMargin, .rounding = 1.0, .gap = 0.5};
/// Never less: float32 distances to the anchor plane round to 2^-24 of the thickness.
constexpr Fit::Give kSnug{.thickness = 0x1p-17, .rounding = 1.0, .gap = 0.5};
/// Between these a previous end is kept.
constexpr Fit::Give kMin{.thickness = 0x1p-18, .rounding = 0.5, .gap = 0.25};
constexpr Fit::Give kMax{.thickness = 2.0 * kMargin, .rounding = 2.0, .gap = 1.0};

Cascades withMargins(const Fit& fit) {
    Cascades cascades;
    for (std::size_t i = 0; i < fit.plan.size(); ++i) {
        const Cascade roomy = fit.widened(i, kRoomy);
        cascades.push_back(fit.meets(roomy, 0.0) ? roomy : fit.widened(i, kSnug));
    }
    return cascades;
}

/// The fresh cascades, with previous bounds where those still enclose the plan closely, and previous cuts.
Cascades keepBounds(const Fit& fit, const Cascades& fresh, std::span<const Cascade> previous) {
    Cascades kept = fresh;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Cascade least = fit.widened(i, kMin);
        const Cascade most = fit.widened(i, kMax);
        const auto within = [](double value, double a, double b) { return value >= a && value <= b; };
        if (touches(fit.plan, i) ? touches(previous, i)
                                 : within(previous[i].nearView, most.nearView, least.nearView)) {
            kept[i].nearView = previous[i].nearView;
        }
        if (touches(fit.plan, i + 1) ? touches(previous, i + 1)
                                     : within(previous[i].farView, least.farView, most.farView)) {
            kept[i].farView = previous[i].farView;
        }
    }
    return kept;
}

bool isSound(const Fit& fit, const Cascades& cascades) {
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        if (!(cascades[i].farView > cascades[i].nearView) || !fit.meets(cascades[i], kFitSlack) ||
            (i > 0 && cascades[i].nearView < cascades[i - 1].farView)) {
            return false;
        }
    }
    return true;
}

} // namespace

Cascades fitCascades(const SplitFitted& split, const SplitContext& context) {
    const StepTarget wanted =
        targetOf(split, context, thinnest(context.visible, context.nearView, context.farView));
    const std::vector<Interval> occupied = mergeIntervals(context.visible, context.nearView, context.farView,
                                                          endRounding(context.model.mapping));
    if (occupied.empty()) {
        return {{context.nearView, context.farView}}; // nothing to see
    }
    const std::size_t most = std::clamp<std::size_t>(split.most, 1, kMaxCascades);
    const StepTarget target = relaxToMeet(context.model, wanted, occupied, most);
    const Cascades plan = planNear(context.model, target, occupied, most, context.previous.size());
    const Fit fit{context, target, plan};
    Cascades cascades = withMargins(fit);
    if (context.previous.size() == plan.size()) {
        const Cascades kept = keepBounds(fit, cascades, context.previous);
        cascades = isSound(fit, kept) ? kept : cascades;
    }
    return cascades;
}

Cascades minimaxCascades(const SplitMinimax& split, const SplitContext& context) {
    const std::vector<Interval> whole{{context.nearView, context.farView}};
    // Far below any step, so that only relaxing decides.
    const StepTarget target{.unitsView = kMinShare * context.nearView};
    const std::size_t count = std::clamp<std::size_t>(split.count, 1, kMaxCascades);
    return planOrOne(context.model, relaxToMeet(context.model, target, whole, count), whole, count);
}

} // namespace cdr::depth
