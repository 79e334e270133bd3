#include <cdr/measure/truth/shape.h>

namespace cdr::measure {

Shape::Shape(const scene::Mesh& mesh) {
    if (mesh.boxHalfSides) {
        m_halfSides = glm::dvec3(*mesh.boxHalfSides);
        return;
    }
    m_triangles.emplace(mesh);
    if (const Bounds& bounds = m_triangles->bounds(); bounds.lower.x <= bounds.upper.x) {
        m_centre = (glm::dvec3(bounds.upper) + glm::dvec3(bounds.lower)) * 0.5;
        m_halfSides = (glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower)) * 0.5;
    }
}

} // namespace cdr::measure
