#pragma once

#include "../notes.h"
#include "nodes.h"

#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// The cameras that nodes carry, where those stand; orthographic ones come last. A node's scale and mirroring do not reach its
/// camera. One whose axes no longer span a space is noted and left out, and so is one that scene::requireUsable() refuses.
/// Refuses a lens that glTF forbids.
/// @param root of the document.
std::vector<GltfCamera> placeCameras(std::span<const CameraNode> nodes, const nlohmann::json& root,
                                     Notes& notes);

} // namespace cdr::scene::gltf
