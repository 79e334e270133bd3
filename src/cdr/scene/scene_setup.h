#pragma once

#include <cdr/scene/animation/mesh_pose.h>
#include <cdr/scene/camera_path.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/world/check.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cdr::platform {
class WorkerPool;
}

namespace cdr::scene {

/// What moves in a scene, as pure functions of the frame number. The scene is as it is at frame 0.
struct SceneMotion {
    std::vector<std::uint32_t> instances{}; ///< that move, by index
    /// Where they are at a frame.
    std::function<std::vector<Transform>(std::uint32_t frame)> transforms{};
    std::vector<std::uint32_t> meshes{}; ///< that deform, by index; their instances are among `instances`
    /// The vertices of these at a frame, as many as each has.
    std::function<std::vector<MeshVertices>(std::uint32_t frame, platform::WorkerPool& workers)> vertices{};
    /// What gives the meshes these vertices; none where `vertices` alone knows. Its bounds are those of the meshes.
    std::function<std::vector<MeshPose>(std::uint32_t frame)> poses{};
    std::vector<std::uint32_t> lights{}; ///< that move, by index
    /// These at a frame, in the same order.
    std::function<std::vector<PointLight>(std::uint32_t frame)> lightsAt{};

    /// Whether anything moves.
    /// @errors None.
    explicit operator bool() const { return !instances.empty() || !lights.empty(); }
};

/// An animation of a file.
struct PlayableAnimation {
    std::string name;     ///< may be empty
    double seconds = 0.0; ///< how long it takes; 0 of one that cannot be played
};

/// How a light of a file shines.
enum class LightType : std::uint8_t { point, directional, spot };

/// A light of a file.
struct ListedLight {
    std::string name;                  ///< may be empty
    LightType type = LightType::point; ///< how it shines
    bool moves = false;                ///< whether the animation that is played moves it
};

/// A scene, the cameras that look at it, and what moves in it.
struct SceneSetup {
    Scene scene;          ///< what is looked at
    CameraPath path;      ///< the cameras that look
    SceneMotion motion{}; ///< what moves
};

/// A scene that was opened by name or from a file.
struct OpenedScene {
    SceneSetup setup;                            ///< scene and cameras
    std::vector<std::string> notes;              ///< what an importer ignored, one line each
    std::vector<PlayableAnimation> animations{}; ///< what a file holds, whether it is played or not
    std::vector<ListedLight> lights{};           ///< what a file holds, whether they are shown or not
    /// Which of the notes says that no animation is played. What plays them leaves it out.
    std::optional<std::size_t> animationsNote{};
};

} // namespace cdr::scene
