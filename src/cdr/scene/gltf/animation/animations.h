#pragma once

#include "../accessor.h"
#include "../memory.h"
#include "../notes.h"
#include "rig.h"

#include <cdr/scene/animation/pose.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace cdr::scene::gltf {

/// Which nodes of a document its animations name: by node.
std::vector<bool> animatedNodes(const nlohmann::json& root);

/// Which nodes of a document have morph targets whose weights its animations change: by node.
std::vector<bool> morphedNodes(const nlohmann::json& root);

/// The animations of a document. Refuses counts and values that do not fit. An animation whose times do not increase
/// from 0 on is noted and left empty, with its fault.
/// Channels that nothing can follow are noted and left out.
std::vector<Animation> readAnimations(const nlohmann::json& root, Accessors& accessors, const FileRig& rig,
                                      MemoryPrediction& memory, Notes& notes);

} // namespace cdr::scene::gltf
