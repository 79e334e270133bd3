#include "layer.h"

#include "../json.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <string_view>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kExtra = "cdr_layer";
constexpr std::string_view kSuffix = "@layer=";

/// NaN for text that is no number.
double numberOf(std::string_view text) {
    double value = std::nan("");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : std::nan("");
}

std::optional<double> written(const json& object) {
    const json* extras = member(object, "extras");
    if (const json* extra = extras != nullptr ? member(*extras, kExtra) : nullptr) {
        return extra->is_number() ? extra->get<double>() : std::nan("");
    }
    const std::string_view name = fullNameOf(object);
    const std::size_t suffix = name.rfind(kSuffix);
    if (suffix == std::string_view::npos) {
        return std::nullopt;
    }
    return numberOf(name.substr(suffix + kSuffix.size()));
}

} // namespace

std::optional<float> layerOf(const json& object, const std::string& where, Notes& notes) {
    const std::optional<double> layer = written(object);
    if (!layer) {
        return std::nullopt;
    }
    const auto offset = static_cast<float>(*layer);
    if (!std::isfinite(offset)) {
        notes.add("a layer that is no finite number is not used", where);
        return std::nullopt;
    }
    return offset;
}

} // namespace cdr::scene::gltf
