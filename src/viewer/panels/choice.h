#pragma once

#include "widgets.h"

#include <viewer/state/explanations.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace cdr::viewer {

/// A choice among the values of an enumeration, each by its name, and below it what the chosen one means.
template <typename Value, std::size_t N>
void choose(const Widgets& widgets, std::string_view name, const std::array<Value, N>& values,
            Value& chosen) {
    const std::size_t picked =
        widgets.combo(name, nameOf(chosen), N, [&](std::size_t i) { return nameOf(values[i]); });
    if (picked < N) {
        chosen = values[picked];
    }
    widgets.sentence(explanationOf(chosen));
}

} // namespace cdr::viewer
