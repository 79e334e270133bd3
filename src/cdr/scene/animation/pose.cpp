#include <cdr/scene/animation/pose.h>

#include <array>
#include <span>

namespace cdr::scene {

namespace {

glm::dvec3 vectorAt(const Keyframes& keyframes, double seconds) {
    std::array<double, 3> value{};
    sampleAt(keyframes, seconds, value);
    return {value[0], value[1], value[2]};
}

/// Writes what a channel moves.
void apply(const Channel& channel, const Keyframes& keyframes, double seconds, const RigNode& node,
           LocalTransform& local, std::span<double> weights) {
    switch (channel.path) {
    case AnimatedPath::translation:
        local.translation = vectorAt(keyframes, seconds);
        break;
    case AnimatedPath::rotation:
        local.rotation = rotationAt(keyframes, seconds);
        break;
    case AnimatedPath::scale:
        local.scale = vectorAt(keyframes, seconds);
        break;
    case AnimatedPath::weights:
        sampleAt(keyframes, seconds, weights.subspan(node.firstWeight, node.weightCount));
        break;
    }
}

} // namespace

glm::dmat4 matrixOf(const LocalTransform& transform) {
    glm::dmat4 matrix = glm::mat4_cast(transform.rotation);
    for (int c = 0; c < 3; ++c) {
        matrix[c] *= transform.scale[c];
        matrix[3][c] = transform.translation[c];
    }
    return matrix;
}

Pose poseAt(const Rig& rig, const Animation* animation, double seconds) {
    Pose pose{.toWorld = {}, .weights = rig.weights};
    std::vector<LocalTransform> locals;
    locals.reserve(rig.nodes.size());
    for (const RigNode& node : rig.nodes) {
        locals.push_back(node.local);
    }
    if (animation != nullptr) {
        for (const Channel& channel : animation->channels) {
            apply(channel, animation->keyframes[channel.keyframes], seconds, rig.nodes[channel.node],
                  locals[channel.node], pose.weights);
        }
    }
    pose.toWorld.reserve(rig.nodes.size());
    for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
        const RigNode& node = rig.nodes[i];
        const glm::dmat4& above = node.parent ? pose.toWorld[*node.parent] : node.parentToWorld;
        pose.toWorld.push_back(above * (node.matrix ? *node.matrix : matrixOf(locals[i])));
    }
    return pose;
}

std::vector<bool> movedBy(const Rig& rig, const Animation& animation) {
    std::vector<bool> moved(rig.nodes.size());
    for (const Channel& channel : animation.channels) {
        moved[channel.node] = true;
    }
    for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
        moved[i] = moved[i] || (rig.nodes[i].parent && moved[*rig.nodes[i].parent]);
    }
    return moved;
}

} // namespace cdr::scene
