#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/scene/animation/deform.h>

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace cdr::scene {

/// All that the vertices of a deformed mesh depend on at a moment.
struct MeshPose {
    std::shared_ptr<const Deformer> deformer; ///< the mesh at rest and what moves it, after finish()
    std::vector<double> weights;              ///< of its morph targets, the first ones; 0 of others
    std::vector<glm::dmat4> joints;           ///< as placeOf() takes them; empty without a skin
    DeformedPlace place;                      ///< where the mesh stands

    /// As deform() takes it.
    /// @lifetime The spans are valid as long as the pose.
    Deformation deformation() const { return {.weights = weights, .joints = joints, .place = place}; }
};

/// @throws base::InputError where positions, normals, tangents, morph targets or weights are not finite. Or where a morph target
/// moves a vertex that is not there, or its vertices do not ascend, or `firstInfluence` does not divide the influences among the
/// vertices. Takes time by the deformer's size.
/// @param what names the mesh in the message, here and below
CDR_EXPORT void requireUsable(const Deformer& deformer, const std::string& what);

/// @throws base::InputError where a pose lacks its deformer, or a joint that this uses, or finish() was left out. Or where a pose
/// with joints has a place whose basis placeOf() does not make. The deformer's own numbers are looked at by the function above.
CDR_EXPORT void requireUsable(const MeshPose& pose, const std::string& what);

/// Bounds the deformed vertices by what each joint moves. Takes time by the number of joints and morph targets, not of
/// vertices. Both paths that deform use it, so that culling and fitted splits do not depend on the path.
/// @return object space, about the mesh's origin; not finite where a vertex may not be
CDR_EXPORT float boundingRadiusOf(const MeshPose& pose);

} // namespace cdr::scene
