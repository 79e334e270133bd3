#pragma once

#include <cdr/render/draw_source.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/output/motion_history.h>
#include <cdr/shaders/motion_shared.h>

namespace cdr::render {

/// How the coordinates of points change from this frame's camera to the last one's: right, up and view distance. All
/// differences are formed in float64, and rounded once.
class MotionMaker {
  public:
    /// @param extent of both pictures
    MotionMaker(const FrameView& view, const scene::Camera& before, vk::Extent2D extent);

    /// @param objects that the table of records covers
    shaders::MotionHeader header(std::uint32_t objects) const;
    shaders::MotionRecord record(const MovedObject& moved) const;
    /// @param source of an instance, where it is now. @param before where it was
    shaders::DeformedPush push(const DrawSource& source, const scene::Transform& before) const;

  private:
    glm::dvec2 m_projection; ///< clip x and y per unit of right and up at view distance 1
    glm::vec2 m_lensShift;
    glm::dvec2 m_centre; ///< Frustum::centre
    glm::dvec2 m_lens;   ///< pixels per unit of right and up at view distance 1
    glm::dvec2 m_lensBefore;
    glm::dvec2 m_centreBefore;
    glm::dvec3 m_position;
    glm::dmat3 m_axes;       ///< of this camera: world space to right, up and ahead
    glm::dmat3 m_axesBefore; ///< of the last one
    glm::dvec3 m_camera;     ///< what the camera's move adds, world space
};

} // namespace cdr::render
