#pragma once

#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/cull_cells.h>

#include <vector>

namespace cdr::visibility {

/// Whether nothing behind a surface of the material can be seen through it: it is opaque, and lies where it is drawn.
bool canOcclude(const scene::Material& material);

/// Least radii of occluders in pixels: where a frame was before, and where there was none.
inline constexpr double kMinOccluder = 4.0;
inline constexpr double kMinFirstOccluder = 24.0;

/// Which of a frame's instances are drawn first, so that the rest can be tested against their depth. They are those that
/// the last frame showed, if they are large enough in the picture to hide anything. Where no frame was before, all that
/// are larger still. Any choice gives the same picture; a good one is quick.
class Occluders {
  public:
    /// Lists them.
    /// @param visible what the camera may see, as cullCells() lists it.
    /// @return valid until the next call.
    const VisibleCells& choose(const scene::Scene& scene, const scene::Frustum& frustum,
                               const VisibleCells& visible);

    /// @param shown of `visible`, what is left once the hidden is out.
    void remember(const VisibleCells& shown) { m_last = shown.parts; }
    /// The next frame is chosen for as a first one.
    void forget() { m_last.clear(); }

  private:
    std::vector<VisibleCells::Part> m_last; ///< by cell, ascending
    VisibleCells m_chosen;
};

} // namespace cdr::visibility
