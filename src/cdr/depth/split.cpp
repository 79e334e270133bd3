#include <cdr/base/number_text.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/split.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace cdr::depth {

namespace {

constexpr std::array<std::string_view, 6> kForms{"none",       "ratio:R",   "count:K",
                                                 "at:A,B,...", "minimax:K", "fitted:TARGET"};

base::Result<unsigned> parseCount(std::string_view what, std::string_view text) {
    const auto count = base::tryParseNumber(what, text);
    if (!count) {
        return count.refusal();
    }
    if (*count < 1.0 || *count > static_cast<double>(kMaxCascades) || *count != std::floor(*count)) {
        return base::Refusal{
            base::concat(what, " must be a whole number from 1 to ", kMaxCascades, ", not ", text)};
    }
    return static_cast<unsigned>(*count);
}

/// Puts a count into the split that has it.
template <typename Counted>
base::Result<Split> parseCounted(std::string_view text) {
    const auto count = parseCount("split count", text);
    return count ? base::Result<Split>(Counted{*count}) : count.refusal();
}

base::Result<Split> parseRatio(std::string_view text) {
    const auto ratio = base::tryParseNumber("split ratio", text);
    if (!ratio) {
        return ratio.refusal();
    }
    if (*ratio <= 1.0) {
        return base::Refusal{base::concat("split ratio must be above 1, not ", *ratio)};
    }
    return Split(SplitRatio{*ratio});
}

/// What follows "fitted:".
base::Result<Split> parseFitted(std::string_view text) {
    SplitFitted split;
    constexpr std::string_view kMax = ",max=";
    if (const std::size_t comma = text.find(kMax); comma != std::string_view::npos) {
        const auto most = parseCount("most cascades of a fitted split", text.substr(comma + kMax.size()));
        if (!most) {
            return most.refusal();
        }
        split.most = *most;
        text = text.substr(0, comma);
    }
    const bool inPixels = text.ends_with("px");
    split.unit = inPixels ? SplitFitted::Unit::pixels : SplitFitted::Unit::scene;
    const auto target =
        base::tryParseNumber("target of a fitted split", text.substr(0, text.size() - (inPixels ? 2 : 0)));
    if (!target) {
        return target.refusal();
    }
    if (*target <= 0.0) {
        return base::Refusal{base::concat("target of a fitted split must be above 0, not ", text)};
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
    const std::vector<double>& boundaries = split.boundariesView;
    if (!std::is_sorted(boundaries.begin(), boundaries.end(), std::less_equal<>()) ||
        boundaries.front() <= 0.0) {
        return base::Refusal{"split boundaries must be above 0 and ascend"};
    }
    return Split(std::move(split));
}

} // namespace

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
