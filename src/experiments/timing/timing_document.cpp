#include "timing_document.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/json_text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cdr::experiments {

namespace {

constexpr int kDeepestDocument = 16; ///< of nested values

/// Without line ends and other control characters, since messages and tables print it.
bool isPrintableName(const std::string& text) {
    return text.size() <= kMaxTimingText && std::none_of(text.begin(), text.end(), [](char c) {
               return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
           });
}

/// A text of an object, or `otherwise` where it has none of that key.
std::string textAt(const nlohmann::json& object, const std::string& key, const std::string& otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) {
        return otherwise;
    }
    if (!found->is_string() || !isPrintableName(found->get_ref<const std::string&>())) {
        throw base::inputError("'{}' is no short text in one line", key);
    }
    return found->get<std::string>();
}

std::pair<std::string, double> modeOf(const nlohmann::json& row) {
    if (!row.is_object()) {
        throw base::InputError("a result is no object");
    }
    const std::string name = textAt(row, "name", textAt(row, "mode", ""));
    if (name.empty()) {
        throw base::InputError("a result names no mode");
    }
    const auto us = row.find("median_us");
    if (us == row.end() || !us->is_number() || !std::isfinite(us->get<double>()) ||
        us->get<double>() <= 0.0) {
        throw base::inputError("'median_us' of {} is no finite number over 0", name);
    }
    return {name, us->get<double>()};
}

TimingDocument documentOf(const nlohmann::json& json) {
    const nlohmann::json& device = json.at("device");
    const nlohmann::json& results = json.at("results");
    if (!device.is_object()) {
        throw base::InputError("'device' is no object");
    }
    if (!results.is_array() || results.empty() || results.size() > kMaxTimingRows) {
        throw base::inputError("'results' is no list of 1 to {} modes", kMaxTimingRows);
    }
    TimingDocument document{.commit = textAt(json, "commit", "unknown"),
                            .device = textAt(device, "name", ""),
                            .driver = textAt(device, "driver", ""),
                            .medianUs = {}};
    std::transform(results.begin(), results.end(), std::back_inserter(document.medianUs), modeOf);
    return document;
}

} // namespace

TimingDocument readTimingDocument(std::string_view text, const std::string& program) {
    try {
        if (text.size() > kMaxTimingBytes) {
            throw base::inputError("they have more than {} MiB", kMaxTimingBytes >> 20u);
        }
        const auto json =
            platform::parseShallow<nlohmann::json>(text, kDeepestDocument, "its values are nested too deep");
        if (json.is_object() && json.contains("results") && json.contains("device")) {
            return documentOf(json);
        }
    } catch (const base::InputError& error) {
        throw base::inputError("{} wrote timing results that cannot be used: {}", program, error.what());
    } catch (const nlohmann::json::exception&) { // no JSON
    }
    throw base::InputError(program + " wrote no timing results");
}

} // namespace cdr::experiments
