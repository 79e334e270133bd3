#pragma once

#include "notes.h"

#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::scene::gltf {

/// What a camera of the file looks through.
struct CameraLens {
    std::string name;
    double fovY = 0.0; ///< radians; 0 of an orthographic camera
    double nearView = 0.0;
    std::optional<double> farView;                ///< none: infinitely far
    std::optional<OrthographicLens> orthographic; ///< instead
};

/// A glTF document, its counts and depth bounded.
struct Document {
    /// Parsed once. The importer reads from it what the scene uses, and checks it there; see json.h.
    nlohmann::json root;
    std::vector<CameraLens> lenses; ///< by camera
};

/// Parses JSON text. Parts that are not used are noted in `notes`.
Document parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes);

} // namespace cdr::scene::gltf
