#include "sentence_parts.h"

#include <cdr/depth/advice.h>

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace cdr::output {

namespace {

constexpr char kLengthMark = '\x1f';

} // namespace

std::string markedLength(double view) {
    return std::isfinite(view) ? fmt::format("{0}{1}{0}", kLengthMark, view) : depth::plainLength(view);
}

nlohmann::ordered_json sentenceParts(const std::vector<std::string>& lines) {
    using Json = nlohmann::ordered_json;
    Json all = Json::array();
    for (const std::string& line : lines) {
        Json parts = Json::array();
        std::istringstream text(line);
        for (std::string part; std::getline(text, part, kLengthMark);) {
            const bool isLength = parts.size() % 2 == 1;
            Json length = isLength ? Json::parse(part, nullptr, false) : Json();
            parts.push_back(length.is_number() ? std::move(length)
                                               : Json(part)); // an object's name may hold the mark
        }
        all.push_back(std::move(parts));
    }
    return all;
}

} // namespace cdr::output
