#pragma once

#include "../document.h"
#include "../notes.h"
#include "nodes.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// The cameras of a document, by index. Refuses a lens that no camera can have.
std::vector<CameraLens> takeLenses(const nlohmann::json& root);

/// The cameras that nodes carry, where those stand; orthographic ones come last. A node's scale and mirroring do not reach its
/// camera; one whose axes no longer span a space is noted and left out.
std::vector<GltfCamera> placeCameras(std::span<const CameraNode> nodes, const Document& document,
                                     Notes& notes);

} // namespace cdr::scene::gltf
