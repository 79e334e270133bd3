#pragma once

#include <scenes/layer_choice.h>

#include <string>
#include <string_view>

namespace cdr::options {

/// Reads "MATERIAL=LAYER". base::InputError unless the layer is 0 or a normal float.
scenes::LayerChoice parseLayer(std::string_view text);
/// What parseLayer() reads.
std::string textOf(const scenes::LayerChoice& choice);

} // namespace cdr::options
