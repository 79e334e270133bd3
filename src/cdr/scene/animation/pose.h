#pragma once

#include <cdr/scene/animation/keyframes.h>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::scene {

/// Scale, then rotation, then translation.
struct LocalTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< of length one
    glm::dvec3 scale{1.0};
};

glm::dmat4 matrixOf(const LocalTransform& transform);

/// A node of a hierarchy, at rest.
struct RigNode {
    std::optional<std::size_t> parent{}; ///< into Rig::nodes, before this one
    glm::dmat4 parentToWorld{1.0}; ///< without a parent in the rig: what lies above it, which never moves
    LocalTransform local;
    std::optional<glm::dmat4> matrix; ///< instead of `local`; no channel moves such a node
    std::size_t firstWeight = 0;      ///< of its morph targets, into Rig::weights
    std::size_t weightCount = 0;
};

/// The nodes that may move and those that skins follow, parents first.
struct Rig {
    std::vector<RigNode> nodes;
    std::vector<double> weights; ///< of morph targets at rest, node by node
};

/// What of a node a channel moves.
enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };

/// Leads keyframes to a node.
struct Channel {
    std::size_t keyframes = 0; ///< into Animation::keyframes, as wide as the path
    std::size_t node = 0;      ///< into Rig::nodes
    AnimatedPath path = AnimatedPath::translation;
};

struct Animation {
    std::string name;     ///< may be empty
    double seconds = 0.0; ///< of its last keyframe
    std::vector<Keyframes> keyframes;
    std::vector<Channel> channels;
    std::string fault{}; ///< why it cannot be played; empty where it can
};

/// A rig at a moment.
struct Pose {
    std::vector<glm::dmat4> toWorld; ///< by node
    std::vector<double> weights;     ///< as Rig::weights
};

/// The rig at rest, or at a moment of an animation, where what no channel moves is at rest.
/// @param animation null for rest
Pose poseAt(const Rig& rig, const Animation* animation, double seconds);

/// Which nodes an animation moves, or changes the weights of: by node.
std::vector<bool> movedBy(const Rig& rig, const Animation& animation);

} // namespace cdr::scene
