#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/split.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace cdr::depth {

namespace {

constexpr std::array<std::string_view, 6> kForms{"none",       "ratio:R",   "count:K",
                                                 "at:A,B,...", "minimax:K", "fitted:TARGET"};

unsigned parseCount(const std::string& what, const std::string& text) {
    const double count = base::parseNumber(what, text);
    if (count < 1.0 || count > static_cast<double>(kMaxCascades) || count != std::floor(count)) {
        throw base::InputError(
            fmt::format("{} must be a whole number from 1 to {}, not {}", what, kMaxCascades, text));
    }
    return static_cast<unsigned>(count);
}

/// What follows "fitted:".
SplitFitted parseFitted(std::string text) {
    SplitFitted split;
    constexpr std::string_view kMost = ",max=";
    const std::size_t most = text.find(kMost);
    if (most != std::string::npos) {
        split.most = parseCount("most cascades of a fitted split", text.substr(most + kMost.size()));
        text.resize(most);
    }
    const bool inPixels = text.ends_with("px");
    split.unit = inPixels ? SplitFitted::Unit::pixels : SplitFitted::Unit::scene;
    split.target =
        base::parseNumber("target of a fitted split", text.substr(0, text.size() - (inPixels ? 2 : 0)));
    if (split.target <= 0.0) {
        throw base::InputError(fmt::format("target of a fitted split must be above 0, not {}", text));
    }
    return split;
}

std::vector<double> parseBoundaries(const std::string& list) {
    std::vector<double> boundaries;
    std::size_t begin = 0;
    while (begin <= list.size()) {
        const std::size_t comma = std::min(list.find(',', begin), list.size());
        boundaries.push_back(base::parseNumber("split boundary", list.substr(begin, comma - begin)));
        begin = comma + 1;
    }
    if (!std::is_sorted(boundaries.begin(), boundaries.end(), std::less_equal<>()) ||
        boundaries.front() <= 0.0) {
        throw base::InputError("split boundaries must be above 0 and ascend");
    }
    return boundaries;
}

[[noreturn]] void throwTooMany(const Split& split, double cascades) {
    throw base::InputError(fmt::format("split {} gives {:.0f} cascades, at most {} are allowed",
                                       nameOf(split), cascades, kMaxCascades));
}

/// The inner boundaries of each split, ascending, strictly within (nearView, farView).
struct InnerBoundaries {
    double nearView;
    double farView;

    std::vector<double> operator()(const SplitNone&) const { return {}; }

    std::vector<double> operator()(const SplitRatio& split) const {
        const double cascades = std::ceil(std::log(farView / nearView) / std::log(split.ratio));
        if (!(split.ratio > 1.0) || cascades > static_cast<double>(kMaxCascades)) {
            throwTooMany(split, cascades);
        }
        std::vector<double> boundaries;
        for (double b = nearView * split.ratio; b < farView; b *= split.ratio) {
            boundaries.push_back(b);
        }
        return boundaries;
    }

    std::vector<double> operator()(const SplitCount& split) const {
        std::vector<double> boundaries;
        for (unsigned i = 1; i < split.count; ++i) {
            boundaries.push_back(nearView *
                                 std::pow(farView / nearView, static_cast<double>(i) / split.count));
        }
        return boundaries;
    }

    std::vector<double> operator()(const SplitAt& split) const {
        std::vector<double> boundaries;
        std::copy_if(split.boundariesView.begin(), split.boundariesView.end(), std::back_inserter(boundaries),
                     [this](double b) { return b > nearView && b < farView; });
        return boundaries;
    }

    std::vector<double> operator()(const SplitFitted& split) const { return refuse(split); }
    std::vector<double> operator()(const SplitMinimax& split) const { return refuse(split); }

    [[noreturn]] static std::vector<double> refuse(const Split& split) {
        throw base::InputError(fmt::format("split {} depends on more than near and far", nameOf(split)));
    }
};

} // namespace

Split parseSplit(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string form = text.substr(0, colon);
    const std::string argument = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (text == "none") {
        return SplitNone{};
    }
    if (form == "ratio") {
        const double ratio = base::parseNumber("split ratio", argument);
        if (ratio <= 1.0) {
            throw base::InputError(fmt::format("split ratio must be above 1, not {}", ratio));
        }
        return SplitRatio{ratio};
    }
    if (form == "count") {
        return SplitCount{parseCount("split count", argument)};
    }
    if (form == "minimax") {
        return SplitMinimax{parseCount("split count", argument)};
    }
    if (text == "fitted") {
        return SplitFitted{};
    }
    if (form == "fitted") {
        return parseFitted(argument);
    }
    if (form == "at") {
        return SplitAt{parseBoundaries(argument)};
    }
    throw base::InputError(base::unknownName("split", text, kForms));
}

std::string nameOf(const Split& split) {
    struct Name {
        std::string operator()(const SplitNone&) const { return "none"; }
        std::string operator()(const SplitRatio& s) const { return fmt::format("ratio:{}", s.ratio); }
        std::string operator()(const SplitCount& s) const { return fmt::format("count:{}", s.count); }
        std::string operator()(const SplitAt& s) const {
            return fmt::format("at:{}", fmt::join(s.boundariesView, ","));
        }
        std::string operator()(const SplitMinimax& s) const { return fmt::format("minimax:{}", s.count); }
        std::string operator()(const SplitFitted& s) const {
            if (s == SplitFitted{}) {
                return "fitted";
            }
            return fmt::format("fitted:{}{}{}", s.target, s.unit == SplitFitted::Unit::pixels ? "px" : "",
                               s.most == SplitFitted{}.most ? "" : fmt::format(",max={}", s.most));
        }
    };
    return std::visit(Name{}, split);
}

bool needsTechnique(const Split& split) {
    return std::holds_alternative<SplitFitted>(split) || std::holds_alternative<SplitMinimax>(split);
}

void requireRange(double nearView, double farView) {
    if (!std::isfinite(nearView) || !std::isfinite(farView) || nearView <= 0.0 || farView <= nearView) {
        throw base::InputError(
            fmt::format("a split needs 0 < near < far, both finite, not near {} far {}", nearView, farView));
    }
}

Cascades makeCascades(const Split& split, double nearView, double farView) {
    requireRange(nearView, farView);
    const std::vector<double> boundaries = std::visit(InnerBoundaries{nearView, farView}, split);
    if (boundaries.size() + 1 > kMaxCascades) {
        throwTooMany(split, static_cast<double>(boundaries.size() + 1));
    }
    Cascades cascades;
    double begin = nearView;
    for (const double boundary : boundaries) {
        // Rounding may make a boundary meet its neighbour; an empty cascade would divide by zero.
        if (boundary > begin && boundary < farView) {
            cascades.push_back({begin, boundary});
            begin = boundary;
        }
    }
    cascades.push_back({begin, farView});
    return cascades;
}

} // namespace cdr::depth
