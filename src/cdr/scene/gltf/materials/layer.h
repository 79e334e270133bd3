#pragma once

#include "../notes.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace cdr::scene::gltf {

/// The layer (Material::layer) that a node or a material of a file asks for. It is a number `cdr_layer` in its extras, else
/// the number in a name that ends in "@layer=" and a number. Empty without either. One that is not finite is noted.
/// @param where for the note.
std::optional<float> layerOf(const nlohmann::json& object, const std::string& where, Notes& notes);

} // namespace cdr::scene::gltf
