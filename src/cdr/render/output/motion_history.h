#pragma once

#include <cdr/render/drawn_scene.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/world/check.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::render {

class LastVertices;

/// An object that is elsewhere than in the last frame, by one of its instances.
struct MovedObject {
    std::uint32_t object = 0;
    scene::Transform before;
    scene::Transform now;
};

/// An instance whose mesh has other vertices than in the last frame.
struct DeformedInstance {
    std::uint32_t instance = 0;
    scene::Transform before;
};

/// What changed between the last frame and this one, as far as it moves what both show.
struct FrameMotion {
    scene::Camera cameraBefore;
    std::vector<MovedObject> moved;         ///< each object once
    std::vector<DeformedInstance> deformed; ///< all in UploadedScene::lastVertices()
};

/// Remembers where everything was in the last frame. Takes time by the number of instances that changed.
class MotionHistory {
  public:
    /// The motion since the last call, none at first. What was added since did not move.
    /// base::InputError where instances of one object moved apart. After any error the next frame is as a first one.
    FrameMotion follow(const DrawnScene& drawn, const scene::Camera& camera);

    /// The next frame is a first one.
    void forget() { *this = {}; }

  private:
    /// A place of the scene's instances in the last frame.
    struct Place {
        scene::Transform transform;
        std::uint32_t object = 0;
        std::uint32_t generation = 0; ///< 0: nothing was there
        std::size_t seen = 0;         ///< the frame that last looked here
    };
    struct Changed {
        std::vector<MovedObject> moved{};
        std::vector<std::uint32_t> added{}; ///< objects, once for each instance
        std::vector<DeformedInstance> deformed{};
        const LastVertices* lastVertices; ///< null where those kept are not of the last frame
    };
    FrameMotion motionSinceLast(const DrawnScene& drawn, const scene::Camera& camera);
    static Place placeOf(const DrawnScene& drawn, std::size_t instance);
    void look(const DrawnScene& drawn, std::size_t instance, Changed& changed);

    std::optional<scene::Camera> m_camera;
    std::uint64_t m_followed = 0; ///< of the scene's changes
    std::uint64_t m_replaced = 0; ///< how often another world took the scene's place
    std::uint64_t m_vertices = 0; ///< UploadedScene::verticesRevision() of the last frame
    std::size_t m_frame = 0;
    std::vector<Place> m_places;
    std::vector<std::uint32_t> m_instances; ///< by object: how many it has
};

} // namespace cdr::render
