#pragma once

#include "../memory.h"
#include "../nodes/nodes.h"

#include <cdr/scene/animation/pose.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace cdr::scene::gltf {

/// The nodes of a file that move or that something follows.
struct FileRig {
    Rig rig;
    std::vector<std::optional<std::size_t>> nodeOf; ///< by node of the file: into Rig::nodes
};

/// Makes a rig of wanted nodes and all below them. Refuses weights that are not as many as a mesh has morph targets.
/// @param root of the document. @param wanted by node of the file
FileRig makeRig(const nlohmann::json& root, const PlacedNodes& nodes, const std::vector<bool>& wanted,
                MemoryPrediction& memory);

/// How many morph targets a mesh of the document has: those of its first primitive.
std::size_t targetCount(const nlohmann::json& root, int mesh);

/// The weights of a node's morph targets at rest.
std::vector<double> restWeights(const nlohmann::json& root, const nlohmann::json& node);

} // namespace cdr::scene::gltf
