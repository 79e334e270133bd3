#pragma once

#include "notes.h"

#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json.hpp>

#include <string_view>

namespace cdr::scene::gltf {

/// Parses JSON text once, its counts and depth bounded. The importer reads from it what the scene uses, and checks it there; see
/// json.h. Parts that are not used are noted in `notes`.
nlohmann::json parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes);

} // namespace cdr::scene::gltf
