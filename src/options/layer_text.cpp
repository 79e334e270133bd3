#include "layer_text.h"

#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace cdr::options {

namespace {

constexpr std::size_t kMaxShown = 60; ///< letters of what was given, in messages

} // namespace

scenes::LayerChoice parseLayer(std::string_view text) {
    const std::size_t equals = text.rfind('=');
    if (equals == 0 || equals == std::string_view::npos) {
        throw base::inputError("a layer must be MATERIAL=LAYER, such as paint=0.002, not '{}'",
                               text.substr(0, kMaxShown));
    }
    const double number = base::parseNumber("a layer", text.substr(equals + 1));
    const auto layer = static_cast<float>(number);
    if (!std::isfinite(layer)) {
        throw base::inputError("a layer must be a finite float, not '{}'",
                               text.substr(equals + 1, kMaxShown));
    }
    if (number != 0.0 && std::abs(number) < static_cast<double>(std::numeric_limits<float>::min())) {
        throw base::inputError("a layer must be 0 or at least {}, since devices take less for 0, not '{}'",
                               std::numeric_limits<float>::min(), text.substr(equals + 1, kMaxShown));
    }
    return {.material = std::string(text.substr(0, equals)), .layer = layer};
}

std::string textOf(const scenes::LayerChoice& choice) {
    return fmt::format("{}={}", choice.material, choice.layer);
}

} // namespace cdr::options
