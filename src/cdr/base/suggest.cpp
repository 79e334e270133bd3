#include <cdr/base/number_text.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace cdr::base {

namespace {

// An unknown name may be long, and the message must stay one line.
constexpr std::size_t kShown = 60;

/// Levenshtein distance, or `limit` where it is not less. Most names are nothing alike, so this looks only at beginnings
/// whose lengths differ by less, and ends where none of them is near. At most kShown characters of `shown`.
std::size_t editDistance(std::string_view shown, std::string_view name, std::size_t limit) {
    if (std::max(shown.size(), name.size()) - std::min(shown.size(), name.size()) >= limit) {
        return limit;
    }
    // By length of a beginning of what is shown: its distance to the name's beginning of length i.
    std::array<std::size_t, kShown + 1> row;
    std::iota(row.begin(), row.begin() + shown.size() + 1, std::size_t{0});
    for (std::size_t i = 1; i <= name.size(); ++i) {
        const std::size_t first = i < limit ? 1 : i - limit + 1;
        const std::size_t last = std::min(shown.size(), i + limit - 1);
        std::size_t diagonal = std::exchange(row[first - 1], std::min(i, limit));
        std::size_t least = row[first - 1];
        for (std::size_t j = first; j <= last; ++j) {
            const std::size_t substituted = diagonal + (name[i - 1] == shown[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min(substituted, std::min(row[j - 1], diagonal) + 1);
            least = std::min(least, row[j]);
        }
        if (least >= limit) {
            return limit;
        }
    }
    return std::min(row[shown.size()], limit);
}

/// How far from a name what is similar to it may be.
std::size_t mostEdits(std::string_view name) {
    return 1 + name.size() / 2;
}

/// The first of the closest names, unless it is not similar; else none.
std::optional<std::string_view> closestOf(std::string_view shown, std::span<const std::string_view> known) {
    std::size_t nearest = 0; // as far as any name lets a similar one be, and one more
    for (const std::string_view name : known) {
        nearest = std::max(nearest, mostEdits(name) + 1);
    }
    std::optional<std::string_view> closest;
    for (const std::string_view name : known) {
        const std::size_t distance = editDistance(shown, name, nearest);
        if (distance < nearest) {
            nearest = distance;
            closest = name;
        }
    }
    return closest && nearest <= mostEdits(*closest) ? closest : std::nullopt;
}

} // namespace

std::optional<std::string_view> nearestName(std::string_view given, std::span<const std::string_view> known) {
    return closestOf(given.substr(0, kShown), known);
}

std::string unknownName(std::string_view what, std::string_view given,
                        std::span<const std::string_view> known) {
    const std::string_view shown = given.substr(0, kShown);
    const std::optional<std::string_view> closest = closestOf(shown, known);
    const std::string hint = closest ? concat("; did you mean '", *closest, "'?") : std::string();
    std::string list;
    for (const std::string_view name : known) {
        list += list.empty() ? "" : ", ";
        list += name;
    }
    return concat("unknown ", what, " '", shown, "'", hint, " (known: ", list, ")");
}

double parseNumber(std::string_view what, std::string_view text) {
    return tryParseNumber(what, text).orThrow();
}

Result<double> tryParseNumber(std::string_view what, std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return Refusal{concat(what, " must be a finite number, not '", text.substr(0, 60), "'")};
    }
    return value;
}

} // namespace cdr::base
