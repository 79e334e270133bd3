#pragma once

#include <cdr/render/shadows/light_view.h>
#include <cdr/render/shadows/receiver_slices.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace cdr::render {

/// Which parts of a map show surfaces that read it: a grid of cells over the map. What meets none of these casts no shadow that is
/// seen (Bittner and others, Shadow Caster Culling for Efficient Shadow Mapping, 2011).
class ReceiverCells {
  public:
    /// @param slice whose surfaces the view shows. @param camera position that the slice is relative to.
    ReceiverCells(const LightView& view, const ReceiverSlice& slice, const glm::dvec3& camera);

    /// Whether a box may lie in the same cell as such a surface, at whatever distance from the light.
    /// @param middle LightView::toLight(). @param half of the box's sides, along the same axes.
    bool meet(const glm::dvec3& middle, const glm::dvec3& half) const;

  private:
    static constexpr std::size_t kSide = 64;
    struct Area {
        glm::dvec2 low; ///< cells
        glm::dvec2 high;
    };
    glm::dvec2 cellsAt(const glm::dvec2& place, double w) const { return (place / w - m_low) * m_perUnit; }
    Area areaOf(const glm::dvec3& middle, const glm::dvec3& half) const;
    void add(const Area& area);
    void keepWithin(const SeenCorners& corners);

    double m_wOffset; ///< LightView
    double m_wPerUnit;
    glm::dvec2 m_low;
    glm::dvec2 m_perUnit;                      ///< cells
    glm::dvec2 m_margin;                       ///< cells
    std::array<std::uint64_t, kSide> m_rows{}; ///< a bit for each cell
};

} // namespace cdr::render
