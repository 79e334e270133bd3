#include <cdr/render/output/motion_records.h>
#include <cdr/render/view_transform.h>

namespace cdr::render {

namespace {

/// Rows right, up and ahead.
glm::dmat3 axesOf(const scene::Camera& camera) {
    return glm::transpose(glm::dmat3(camera.right, camera.up, -camera.back));
}

glm::vec4 highOf(const glm::dvec3& value) {
    return glm::vec4(glm::vec3(value), 0.0f);
}

glm::vec4 restOf(const glm::dvec3& value) {
    return {splitDouble(value.x).y, splitDouble(value.y).y, splitDouble(value.z).y, 0.0f};
}

/// A row with its last entry as a pair.
glm::vec4 pairedRow(const glm::dmat3& matrix, int row) {
    return {glm::vec2(matrix[0][row], matrix[1][row]), splitDouble(matrix[2][row])};
}

glm::vec3 rowOf(const glm::dmat3& matrix, int row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row]};
}

/// Pixels per unit of slope; y points down.
glm::dvec2 pixelsOf(const scene::Frustum& lens, const vk::Extent2D& extent) {
    return {0.5 * extent.width / lens.tanX, -0.5 * extent.height / lens.tanY};
}

} // namespace

MotionMaker::MotionMaker(const FrameView& view, const scene::Camera& before, vk::Extent2D extent)
    : m_projection(1.0 / view.frustum.tanX, -1.0 / view.frustum.tanY),
      m_lensShift(clipLensShift(view.frustum)),
      m_centre(view.frustum.centre),
      m_lens(pixelsOf(view.frustum, extent)),
      m_lensBefore(pixelsOf(scene::frustumOf(before, extent.width, extent.height), extent)),
      m_centreBefore(before.lensShift),
      m_position(view.camera.position),
      m_axes(axesOf(view.camera)),
      m_axesBefore(axesOf(before)),
      m_camera(view.camera.position - before.position) {}

shaders::MotionHeader MotionMaker::header(std::uint32_t objects) const {
    // Differences first: a camera that does not turn adds nothing, to the bit.
    const glm::dmat3 turn = (m_axesBefore - m_axes) * glm::transpose(m_axes);
    const glm::dvec3 shift = m_axesBefore * m_camera;
    return {.turnRight = pairedRow(turn, 0),
            .turnUp = pairedRow(turn, 1),
            .turnAhead = pairedRow(turn, 2),
            .shift = highOf(shift),
            .shiftRest = restOf(shift),
            .pixels = glm::vec2(m_lensBefore),
            .pixelsAdded = glm::vec2(m_lensBefore - m_lens),
            .objects = objects,
            .unused = 0,
            .middle = glm::vec2(m_centre * m_lens - m_centreBefore * m_lensBefore)};
}

shaders::MotionRecord MotionMaker::record(const MovedObject& moved) const {
    const glm::dmat3 now(moved.now.basis);
    const glm::dmat3 turned = glm::dmat3(moved.before.basis) - now;
    const glm::dmat3 turn = turned == glm::dmat3(0.0) || glm::determinant(now) == 0.0
                                ? glm::dmat3(0.0)
                                : m_axesBefore * turned * glm::inverse(now) * glm::transpose(m_axes);
    const glm::dvec3 centre = m_axes * (moved.now.position - m_position);
    const glm::dvec3 shift = m_axesBefore * (m_camera + (moved.before.position - moved.now.position));
    const glm::vec2 ahead = splitDouble(centre.z);
    return {.right = glm::vec4(rowOf(turn, 0), static_cast<float>(centre.x)),
            .up = glm::vec4(rowOf(turn, 1), static_cast<float>(centre.y)),
            .ahead = glm::vec4(rowOf(turn, 2), ahead.x),
            .shift = glm::vec4(glm::vec3(shift), ahead.y),
            .shiftRest = restOf(shift)};
}

shaders::DeformedPush MotionMaker::push(const DrawSource& source, const scene::Transform& before) const {
    const glm::dmat3 now = m_axes * glm::dmat3(source.basis);
    const glm::dvec3 origin = m_axes * (source.position - m_position);
    const glm::dmat3 was = m_axesBefore * glm::dmat3(before.basis);
    const glm::vec2 ahead = splitDouble(origin.z);
    return {.right = glm::vec4(rowOf(now, 0), static_cast<float>(origin.x)),
            .up = glm::vec4(rowOf(now, 1), static_cast<float>(origin.y)),
            .ahead = glm::vec4(rowOf(now, 2), ahead.x),
            .rightBefore = glm::vec4(rowOf(was, 0), ahead.y),
            .upBefore = glm::vec4(rowOf(was, 1), 0.0f),
            .aheadBefore = glm::vec4(rowOf(was, 2), 0.0f),
            .projection = glm::vec2(m_projection),
            .lens = m_lensShift,
            .id = source.id & shaders::kIdMask,
            .unused = 0};
}

} // namespace cdr::render
