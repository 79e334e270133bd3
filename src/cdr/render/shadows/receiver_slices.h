#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/occupancy.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/scene/frustum.h>
#include <cdr/visibility/cull_cells.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// What is seen, as a sphere around it.
struct SeenSphere {
    glm::dvec3 centre{0.0}; ///< world axes, relative to the camera
    double radius = 0.0;
    double distanceView = 0.0; ///< of the centre
};

/// Surfaces of about the same distance, which a light's map is made for. Corners are world axes, relative to the camera.
struct ReceiverSlice {
    double nearView = 0.0;           ///< view distance, included
    double farView = 0.0;            ///< view distance, left out
    std::array<glm::dvec3, 8> view;  ///< the part of the camera's frustum between them
    std::vector<SeenSphere> seen{};  ///< that reach into that part
    std::array<glm::dvec3, 8> boxes; ///< a box around them
    glm::dvec3 middle{0.0};          ///< of both, about
    double reach = 0.0;              ///< from there, about
    /// Between these, right and up per unit of view distance, are its surfaces in the picture.
    glm::dvec2 lowRay{0.0};
    glm::dvec2 highRay{0.0};
};

/// By how much a slice's far end is farther than its near one: then a texel that suits one suits the other.
inline constexpr double kSliceRatio = 2.0;
/// Of a frame: intervals between powers of two, over a range of depth::kMaxFarOverNear. It may begin and end within one.
inline constexpr std::uint32_t kMaxReceiverSlices = 121;
static_assert(kSliceRatio == 2.0 && depth::kMaxFarOverNear <= 0x1p120);

/// Those of visible instances.
std::vector<SeenSphere> seenSpheres(const scene::Camera& camera, const visibility::VisibleCells& visible);

/// Around all of the frustum at these view distances, where a host draws anything anywhere. Between two intervals in the same
/// slice too. What lies out of the camera's range is left out.
void addOccupied(std::vector<SeenSphere>& seen, const scene::Camera& camera, const scene::Frustum& frustum,
                 std::span<const depth::Interval> occupied);

/// The slices in which something is seen, nearest first. Their ends are powers of kSliceRatio, whatever is seen: a surface
/// that keeps its distance keeps its slice.
std::vector<ReceiverSlice> receiverSlices(const scene::Camera& camera, const scene::Frustum& frustum,
                                          std::span<const SeenSphere> seen);

/// receiverSlices(), or for ShadowMethod::plain four slices of the whole frustum, from the nearest surface that is seen to the
/// farthest. Ends are halfway between those of an even split and of one even in ratio (Zhang and others 2006).
std::vector<ReceiverSlice> slicesOf(ShadowMethod method, const scene::Camera& camera,
                                    const scene::Frustum& frustum, std::span<const SeenSphere> seen);

} // namespace cdr::render
