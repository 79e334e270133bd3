#pragma once

#include "primitive.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// Names the objects of a node, one for each primitive of its mesh. A single one has the node's name. Several have the names
/// of their materials as well, with the number of the primitive where materials are alike: "house / glass",
/// "house / brick 1". Without a name of the material: "house / part 2".
/// @param root of the document. @param node its name, of any length. What several objects take of it is bounded.
std::vector<std::string> partNames(const nlohmann::json& root, const MeshSource& mesh,
                                   const std::string& node);

} // namespace cdr::scene::gltf
