#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/split.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

} // namespace cdr::depth
