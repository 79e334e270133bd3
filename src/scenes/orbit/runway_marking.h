#pragma once

#include <cdr/scene/lod/mesh_pieces.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cdr::scenes {

/// Paint as flat meshes that face up (+y) at y = 0. Points in its plane are (right, ahead), as seen by a pilot who
/// rolls along the runway. For a runway to the east, right is world z and ahead is world x.
class MarkingPaint {
  public:
    /// Whether a stroke's last point is joined to its first.
    enum class Ends : std::uint8_t { open, joined };

    explicit MarkingPaint(std::string name) { m_mesh.name = std::move(name); }

    /// A stroke of even width along points, mitred where it bends.
    void stroke(std::span<const glm::dvec2> points, double width, Ends joins);
    void rectangle(const glm::dvec2& low, const glm::dvec2& high);
    /// Characters of `height` side by side, their middle at the origin. base::InputError for one that is not
    /// among 0 2 7 9 L R.
    void text(std::string_view characters, double height);

    const scene::SourceMesh& mesh() const { return m_mesh; }

  private:
    void quad(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

    scene::SourceMesh m_mesh;
};

} // namespace cdr::scenes
