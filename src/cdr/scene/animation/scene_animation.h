#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/animation/deform.h>
#include <cdr/scene/animation/pose.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/scene_setup.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cdr::scene {

/// The joints that meshes follow.
struct Skin {
    std::vector<std::size_t> joints;     ///< into Rig::nodes
    std::vector<glm::dmat4> inverseBind; ///< by joint
};

/// An instance that goes with a node.
struct CarriedInstance {
    std::uint32_t instance = 0;
    std::size_t node = 0;               ///< into Rig::nodes
    glm::dvec3 origin{0.0};             ///< of its mesh, in the node's space, or in that of a copy
    std::optional<glm::dmat4> toNode{}; ///< of a copy
};

/// An instance of a mesh that deforms.
struct DeformedCopy {
    std::uint32_t instance = 0;
    std::optional<glm::dmat4> toNode{}; ///< of a copy, which no skin places
};

/// A mesh that deforms as a node has it, and what shows it there.
struct DeformedMesh {
    std::vector<DeformedCopy> copies;
    std::uint32_t mesh = 0;
    std::size_t node = 0;            ///< into Rig::nodes
    std::optional<std::size_t> skin; ///< into SceneAnimation::skins
    Deformer deformer;
};

/// What of a scene nodes move. A flat transform, which nothing drawn has, makes an instance vanish.
struct SceneAnimation {
    Rig rig;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<CarriedInstance> carried;
    std::vector<DeformedMesh> deformed;
};

/// Which moment of an animation a frame shows.
struct FrameClock {
    double start = 0.0;           ///< seconds, of frame 0
    double framesPerSecond = 0.0; ///< 0: every frame shows the same moment

    double secondsAt(std::uint32_t frame) const {
        return framesPerSecond > 0.0 ? start + frame / framesPerSecond : start;
    }
};

/// What one of the animations moves, and how.
/// @param chosen into SceneAnimation::animations; none: all that deforms, at rest
SceneMotion motionOf(const std::shared_ptr<const SceneAnimation>& animation,
                     std::optional<std::size_t> chosen, const FrameClock& clock);

/// Brings a scene to a frame, with the least bounds. base::InputError where a frame puts something where nothing can be drawn.
void show(Scene& scene, const SceneMotion& motion, std::uint32_t frame, platform::WorkerPool& workers);

/// Gives what deforms the bounds of its poses, which contain the least ones. So the scene is as a frame of its motion.
void boundByPoses(Scene& scene, const SceneMotion& motion, std::uint32_t frame);

} // namespace cdr::scene
