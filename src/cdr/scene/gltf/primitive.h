#pragma once

#include "draco/extension.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// glTF's numbers for how corners become shapes.
inline constexpr int kModePoints = 0;
inline constexpr int kModeLines = 1;
inline constexpr int kModeLineLoop = 2;
inline constexpr int kModeLineStrip = 3;
inline constexpr int kModeTriangles = 4;
inline constexpr int kModeTriangleStrip = 5;
inline constexpr int kModeTriangleFan = 6;

struct DecodedPrimitive;

/// What a document says of a primitive. Indices are non-negative, or -1 for none, and not yet checked against
/// what they index.
struct Primitive {
    int mode = kModeTriangles;
    int indices = -1;
    int material = -1;
    std::map<std::string, int> attributes; ///< accessors
    std::size_t jointSets = 0; ///< of four joints: those of JOINTS_0, JOINTS_1 and so on, with weights
    std::vector<std::map<std::string, int>> targets; ///< of morph targets: their accessors
    bool hasExtensions = false;
    std::optional<DracoPrimitive> draco;             ///< where it has to be decoded
    std::shared_ptr<const DecodedPrimitive> decoded; ///< null until it is (draco/decompressor.h)
};

/// A mesh of a document.
struct MeshSource {
    std::string name; ///< may be empty, or of any length
    std::vector<Primitive> primitives;
};

/// Reads a mesh. Refuses one that does not exist, is unsound, or has a primitive that is.
/// @param root of the document.
MeshSource readMesh(const nlohmann::json& root, int mesh);

/// Names a primitive in messages.
std::string placeOf(int mesh, const std::string& name, std::size_t primitive);

} // namespace cdr::scene::gltf
