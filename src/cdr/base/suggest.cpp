#include <cdr/base/number_text.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

namespace cdr::base {

namespace {

/// Levenshtein distance, one row at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::string unknownName(std::string_view what, std::string_view given,
                        std::span<const std::string_view> known) {
    std::string hint;
    // An unknown name may be long, and the message must stay one line.
    const std::string_view shown = given.substr(0, 60);
    const auto closest =
        std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
            return editDistance(shown, a) < editDistance(shown, b);
        });
    if (closest != known.end() && editDistance(shown, *closest) <= 1 + closest->size() / 2) {
        hint = concat("; did you mean '", *closest, "'?");
    }
    std::string list;
    for (const std::string_view name : known) {
        list += concat(list.empty() ? "" : ", ", name);
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
