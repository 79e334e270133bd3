#pragma once

#include <cdr/depth/make_cascades.h>
#include <cdr/depth/technique.h>
#include <cdr/scene/frustum.h>
#include <cdr/visibility/cull_cells.h>

#include <span>
#include <utility>
#include <vector>

namespace cdr::render {

/// Cuts each frame's view distances into cascades by a technique's split. Remembers the last frame's, so that
/// fitted ones stay put.
class FrameSplit {
  public:
    explicit FrameSplit(const depth::Technique& technique) : m_technique(technique) {}

    /// Of one camera, or of several that share their cascades. base::InputError for an unusable split or range.
    /// @param camera any of them: their lenses are the same. @param frustum of the camera and the picture.
    /// @param visible what each of them sees. @param occupied view distances of what is not visible cells.
    depth::Cascades cut(const scene::Camera& camera, const scene::Frustum& frustum,
                        std::span<const visibility::VisibleCells* const> visible,
                        std::span<const depth::Interval> occupied);

    /// The next frame is cut as a first one is.
    void forget() { m_previous.clear(); }
    /// The last frame's cascades.
    const depth::Cascades& previous() const { return m_previous; }
    /// Takes back the last cut: the frame that it was made for is not drawn. @param previous as it was before.
    void takeBack(depth::Cascades previous) { m_previous = std::move(previous); }

    /// Whether cut() reads the visible list.
    bool needsVisible() const { return std::holds_alternative<depth::SplitFitted>(m_technique.split); }

    depth::FarEnd farEnd() const { return depth::farEndOf(m_technique.split); }

  private:
    depth::Technique m_technique;
    depth::Cascades m_previous;               ///< the last frame's
    std::vector<depth::Interval> m_intervals; ///< kept so that a warm frame allocates little
};

} // namespace cdr::render
