#pragma once

#include "notes.h"

#include <cdr/scene/gltf/gltf.h>

#include <tiny_gltf.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::scene::gltf {

/// Where the bytes of a buffer or an image are.
struct DataSource {
    std::string name;
    std::optional<std::string> uri; ///< else the BIN chunk (a buffer) or a buffer view (an image)
    int bufferView = -1;            ///< images only
    std::size_t byteLength = 0;     ///< buffers only
};

/// What a camera of the file looks through.
struct CameraLens {
    std::string name;
    bool isPerspective = false; ///< if not, nothing of the rest is known
    double fovY = 0.0;          ///< radians
    double nearView = 0.0;
    std::optional<double> farView; ///< none: infinitely far
};

/// A glTF document, its counts and depth bounded. Indices into `model` are non-negative or -1, and not yet
/// checked against what they index.
struct Document {
    tinygltf::Model model; ///< without buffers and images, animations, skins and cameras
    std::vector<DataSource> buffers;
    std::vector<DataSource> images;
    std::vector<CameraLens> lenses; ///< by camera
};

/// Parses JSON text. tinygltf sees neither files nor bytes: its 2.7.0 loads images from buffer views
/// unchecked, so buffers and images are taken out first, and with them the parts that we do not use, noted in
/// `notes`.
Document parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes);

} // namespace cdr::scene::gltf
