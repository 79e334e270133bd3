#pragma once

#include "notes.h"

#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json.hpp>

#include <string_view>

namespace cdr::scene::gltf {

/// A glTF document, its counts and depth bounded.
struct Document {
    /// Parsed once. The importer reads from it what the scene uses, and checks it there; see json.h.
    nlohmann::json root;
};

/// Parses JSON text. Parts that are not used are noted in `notes`.
Document parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes);

} // namespace cdr::scene::gltf
