#pragma once

#include "../accessor.h"
#include "../memory.h"
#include "../mesh.h"
#include "../primitive.h"

#include <cdr/scene/animation/deform.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace cdr::scene::gltf {

/// What a deformer takes, predicted from the counts of accessors.
PrimitiveBytes predictDeformer(const Primitive& primitive, Accessors& accessors);

/// Refuses morph targets with more or fewer elements than the primitive has vertices, used or not.
/// @param root of the document.
void requireTargets(const nlohmann::json& root, const Primitive& primitive, Accessors& accessors,
                    const std::string& where);

/// What deforms a primitive. Refuses joints beyond the skin's, weights that are negative or not finite, and morph targets
/// that do not fit the primitive.
/// @param joints of the skin; 0 without one
Deformer makeDeformer(const Primitive& primitive, const SourcePrimitive& source, Accessors& accessors,
                      std::size_t joints, Notes& notes, const std::string& where);

} // namespace cdr::scene::gltf
