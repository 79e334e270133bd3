#include <cdr/base/error.h>
#include <cdr/scene/animation/mesh_pose.h>
#include <cdr/scene/rounded_up.h>
#include <cdr/scene/world/check.h>

#include <algorithm>
#include <cmath>

namespace cdr::scene {

namespace {

/// Covers the roundings of the vertices, and of the bounds themselves.
constexpr double kRoundings = 1e-6;
/// The same for what is rounded by how far the model is from the world's origin.
constexpr double kWorldRoundings = 1e-14;

/// No vector gets longer by more than this factor: the root of a bound of the largest eigenvalue of the matrix squared.
double stretchOf(const glm::dmat3& matrix) {
    const glm::dmat3 squared = glm::transpose(matrix) * matrix;
    double most = 0.0;
    for (int row = 0; row < 3; ++row) {
        most =
            std::max(most, std::abs(squared[0][row]) + std::abs(squared[1][row]) + std::abs(squared[2][row]));
    }
    return std::sqrt(most);
}

/// How far the morph targets move a vertex at most.
double morphedBy(const MeshPose& pose) {
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(pose.weights.size(), pose.deformer->targetReach.size()); ++i) {
        most += std::abs(pose.weights[i]) * pose.deformer->targetReach[i];
    }
    return most;
}

/// Numbers of float32 have a finite sum in float64.
bool isFiniteVector(const glm::vec3& v) {
    return std::isfinite(glm::dot(glm::dvec3(v), glm::dvec3(1.0)));
}

void requireTarget(const std::vector<MorphDelta>& target, std::size_t vertices, const std::string& what) {
    if (std::adjacent_find(target.begin(), target.end(), [](const MorphDelta& a, const MorphDelta& b) {
            return a.vertex >= b.vertex;
        }) != target.end()) {
        throw base::InputError(what + ": the vertices of a morph target must ascend, each once");
    }
    if (!target.empty() && target.back().vertex >= vertices) {
        throw base::InputError(what + ": a morph target moves a vertex that its deformer has not");
    }
    if (!std::all_of(target.begin(), target.end(), [](const MorphDelta& delta) {
            return isFiniteVector(delta.position) && isFiniteVector(delta.normal) &&
                   isFiniteVector(delta.tangent);
        })) {
        throw base::InputError(what + ": its morph targets must be finite");
    }
}

bool isIdentityOrMirror(const glm::dmat3& basis) {
    return basis == glm::dmat3(1.0) || glm::dmat3(-basis[0], basis[1], basis[2]) == glm::dmat3(1.0);
}

} // namespace

void requireUsable(const Deformer& deformer, const std::string& what) {
    if (!std::all_of(deformer.vertices.begin(), deformer.vertices.end(), [](const Vertex& vertex) {
            return isFiniteVector(vertex.position) && isFiniteVector(vertex.normal);
        })) {
        throw base::InputError(what + ": its vertices must be finite");
    }
    requireUsable(deformer.details, deformer.vertices.size(), what);
    for (const std::vector<MorphDelta>& target : deformer.targets) {
        requireTarget(target, deformer.vertices.size(), what);
    }
    if (!std::all_of(deformer.influences.begin(), deformer.influences.end(),
                     [](const Influence& influence) { return std::isfinite(influence.weight); })) {
        throw base::InputError(what + ": the weights of its joints must be finite");
    }
    if (!hasInfluencesByVertex(deformer)) {
        throw base::InputError(what + ": its firstInfluence must divide its influences among its vertices");
    }
}

void requireUsable(const MeshPose& pose, const std::string& what) {
    if (pose.deformer == nullptr) {
        throw base::InputError(what + ": its pose has no deformer");
    }
    const Deformer& deformer = *pose.deformer;
    const std::size_t vertices = deformer.vertices.size();
    if (!deformer.details.empty() && deformer.details.size() != vertices) {
        throw base::InputError(what + ": its deformer needs details for all vertices, or none");
    }
    if (deformer.targetReach.size() != deformer.targets.size() ||
        deformer.jointReaches.empty() != deformer.influences.empty()) {
        throw base::InputError(what + ": its deformer is not as finish() leaves it");
    }
    const std::size_t needed =
        deformer.jointReaches.empty() ? 1 : deformer.jointReaches.back().joint + std::size_t{1};
    if (!pose.joints.empty() &&
        (deformer.firstInfluence.size() != vertices + 1 || pose.joints.size() < needed)) {
        throw base::InputError(what + ": its pose has other joints than its deformer");
    }
    if (!pose.joints.empty() && !isIdentityOrMirror(pose.place.basis)) {
        throw base::InputError(what + ": with joints, the basis of its place must be as placeOf() makes it");
    }
}

float boundingRadiusOf(const MeshPose& pose) {
    const Deformer& deformer = *pose.deformer;
    const double morphed = morphedBy(pose);
    if (pose.joints.empty()) {
        return roundedUp((deformer.reach + morphed) * (1.0 + kRoundings));
    }
    double most = 0.0;
    double fromOrigin = glm::length(pose.place.position);
    for (const JointReach& joint : deformer.jointReaches) {
        const glm::dmat4& matrix = pose.joints[joint.joint];
        const double fromPlace =
            glm::length(glm::dvec3(matrix * glm::dvec4(joint.centre, 1.0)) - pose.place.position);
        const double stretch = stretchOf(glm::dmat3(matrix));
        const double reach = fromPlace + stretch * (joint.radius + morphed);
        // A NaN must not get lost in a comparison.
        most = std::isnan(most) || reach <= most ? most : reach;
        fromOrigin = std::max(fromOrigin, glm::length(glm::dvec3(matrix[3])) +
                                              stretch * (glm::length(joint.centre) + joint.radius));
    }
    const double offByWeights = deformer.weightError * glm::length(pose.place.position);
    return roundedUp(deformer.weightSize * (most * (1.0 + kRoundings) + kWorldRoundings * fromOrigin) +
                     offByWeights);
}

} // namespace cdr::scene
