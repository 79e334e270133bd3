#include <cdr/base/number_text.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/split.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace cdr::depth {

namespace {

constexpr std::array<std::string_view, 6> kForms{"none",       "ratio:R",   "count:K",
                                                 "at:A,B,...", "minimax:K", "fitted:TARGET"};

using FoundProblem = std::optional<base::Refusal>;

/// @param text that the count was read from
FoundProblem problemOfCount(std::string_view what, double count, std::string_view text) {
    if (count >= 1.0 && count <= static_cast<double>(kMaxCascades) && count == std::floor(count)) {
        return std::nullopt;
    }
    return base::Refusal{
        base::concat(what, " must be a whole number from 1 to ", kMaxCascades, ", not ", text)};
}

/// @param text that the value was read from
FoundProblem problemOfValue(std::string_view what, double value, double bound, std::string_view text) {
    if (!std::isfinite(value)) {
        return base::Refusal{base::concat(what, " must be a finite number, not '", text, "'")};
    }
    if (value <= bound) {
        return base::Refusal{base::concat(what, " must be above ", bound, ", not ", text)};
    }
    return std::nullopt;
}

constexpr std::string_view kCountName = "split count";
constexpr std::string_view kRatioName = "split ratio";
constexpr std::string_view kMostName = "most cascades of a fitted split";
constexpr std::string_view kTargetName = "target of a fitted split";

/// What is out of range, by kind of split.
struct FindProblem {
    FoundProblem operator()(const SplitNone&) const { return std::nullopt; }
    FoundProblem operator()(const SplitRatio& s) const {
        return problemOfValue(kRatioName, s.ratio, 1.0, base::concat(s.ratio));
    }
    FoundProblem operator()(const SplitCount& s) const {
        return problemOfCount(kCountName, s.count, base::concat(s.count));
    }
    FoundProblem operator()(const SplitMinimax& s) const {
        return problemOfCount(kCountName, s.count, base::concat(s.count));
    }
    FoundProblem operator()(const SplitAt& s) const {
        if (s.boundariesView.empty()) {
            return base::Refusal{"a split at boundaries must have one at least"};
        }
        double before = 0.0;
        for (const double boundary : s.boundariesView) {
            if (!(boundary > before)) { // not a number, too
                return base::Refusal{"split boundaries must be above 0 and ascend"};
            }
            before = boundary;
        }
        return std::nullopt;
    }
    FoundProblem operator()(const SplitFitted& s) const {
        if (const FoundProblem problem = problemOfCount(kMostName, s.most, base::concat(s.most))) {
            return problem;
        }
        const char* unit = s.unit == SplitFitted::Unit::pixels ? "px" : "";
        return problemOfValue(kTargetName, s.target, 0.0, base::concat(s.target, unit));
    }
};

base::Result<Split> checkedSplit(Split split) {
    if (const FoundProblem problem = splitProblem(split)) {
        return *problem;
    }
    return split;
}

base::Result<unsigned> parseCount(std::string_view what, std::string_view text) {
    const auto count = base::tryParseNumber(what, text);
    if (!count) {
        return count.refusal();
    }
    if (const FoundProblem problem = problemOfCount(what, *count, text)) {
        return *problem;
    }
    return static_cast<unsigned>(*count);
}

/// Puts a count into the split that has it.
template <typename Counted>
base::Result<Split> parseCounted(std::string_view text) {
    const auto count = parseCount(kCountName, text);
    return count ? base::Result<Split>(Counted{*count}) : count.refusal();
}

base::Result<Split> parseRatio(std::string_view text) {
    const auto ratio = base::tryParseNumber(kRatioName, text);
    return ratio ? checkedSplit(SplitRatio{*ratio}) : ratio.refusal();
}

/// What follows "fitted:".
base::Result<Split> parseFitted(std::string_view text) {
    SplitFitted split;
    constexpr std::string_view kMax = ",max=";
    if (const std::size_t comma = text.find(kMax); comma != std::string_view::npos) {
        const auto most = parseCount(kMostName, text.substr(comma + kMax.size()));
        if (!most) {
            return most.refusal();
        }
        split.most = *most;
        text = text.substr(0, comma);
    }
    const bool inPixels = text.ends_with("px");
    split.unit = inPixels ? SplitFitted::Unit::pixels : SplitFitted::Unit::scene;
    const auto target = base::tryParseNumber(kTargetName, text.substr(0, text.size() - (inPixels ? 2 : 0)));
    if (!target) {
        return target.refusal();
    }
    if (const FoundProblem problem = problemOfValue(kTargetName, *target, 0.0, text)) {
        return *problem;
    }
    split.target = *target;
    return Split(split);
}

base::Result<Split> parseBoundaries(std::string_view list) {
    SplitAt split;
    std::size_t begin = 0;
    while (begin <= list.size()) {
        const std::size_t comma = std::min(list.find(',', begin), list.size());
        const auto boundary = base::tryParseNumber("split boundary", list.substr(begin, comma - begin));
        if (!boundary) {
            return boundary.refusal();
        }
        split.boundariesView.push_back(*boundary);
        begin = comma + 1;
    }
    return checkedSplit(std::move(split));
}

} // namespace

std::optional<base::Refusal> splitProblem(const Split& split) {
    return std::visit(FindProblem{}, split);
}

Split parseSplit(std::string_view text) {
    return tryParseSplit(text).orThrow();
}

base::Result<Split> tryParseSplit(std::string_view text) {
    if (text == "none") {
        return Split(SplitNone{});
    }
    if (text == "fitted") {
        return Split(SplitFitted{});
    }
    const std::size_t colon = text.find(':');
    const std::string_view form = text.substr(0, colon);
    const std::string_view argument = colon == std::string_view::npos ? "" : text.substr(colon + 1);
    if (form == "ratio") {
        return parseRatio(argument);
    }
    if (form == "count") {
        return parseCounted<SplitCount>(argument);
    }
    if (form == "minimax") {
        return parseCounted<SplitMinimax>(argument);
    }
    if (form == "fitted") {
        return parseFitted(argument);
    }
    if (form == "at") {
        return parseBoundaries(argument);
    }
    return base::Refusal{base::unknownName("split", text, kForms)};
}

std::string nameOf(const Split& split) {
    struct Name {
        std::string operator()(const SplitNone&) const { return "none"; }
        std::string operator()(const SplitRatio& s) const { return base::concat("ratio:", s.ratio); }
        std::string operator()(const SplitCount& s) const { return base::concat("count:", s.count); }
        std::string operator()(const SplitAt& s) const {
            std::string text;
            for (const double boundary : s.boundariesView) {
                text += base::concat(text.empty() ? "at:" : ",", boundary);
            }
            return text;
        }
        std::string operator()(const SplitMinimax& s) const { return base::concat("minimax:", s.count); }
        std::string operator()(const SplitFitted& s) const {
            if (s == SplitFitted{}) {
                return "fitted";
            }
            return base::concat("fitted:", s.target, s.unit == SplitFitted::Unit::pixels ? "px" : "",
                                s.most == SplitFitted{}.most ? "" : base::concat(",max=", s.most));
        }
    };
    return std::visit(Name{}, split);
}

} // namespace cdr::depth
