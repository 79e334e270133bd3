#pragma once

#include "../accessor.h"
#include "rig.h"

#include <cdr/scene/animation/scene_animation.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace cdr::scene::gltf {

/// The nodes that a skin of the document follows. Refuses a skin without joints, or with one that does not exist.
std::vector<int> jointNodes(const nlohmann::json& root, int skin);

/// A skin of the document. Refuses inverse bind matrices that are too few, no matrices, or not finite.
/// @param rig holds its joints
Skin readSkin(const nlohmann::json& root, int skin, Accessors& accessors, const FileRig& rig,
              MemoryPrediction& memory);

} // namespace cdr::scene::gltf
