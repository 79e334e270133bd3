#pragma once

#include <cdr/depth/occupancy.h>
#include <cdr/visibility/instance_cells.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// The instances a camera may see, by cell. Valid until the cells change.
struct VisibleCells {
    /// Some slots of a cell.
    struct Part {
        std::uint32_t cell = 0;
        std::uint64_t slots = 0; ///< a bit each; may be 0
    };

    const InstanceCells* cells = nullptr;
    SphereTest test; ///< that they passed
    std::vector<Part> parts;

    std::size_t count() const; ///< of instances
};

/// Keeps every instance that cullSpheres() keeps. Cells wholly inside or outside the frustum are not examined.
/// The result is the same for any number of workers.
/// @param visible overwritten, and kept from frame to frame so that a warm one allocates nothing.
void cullCells(const InstanceCells& cells, const scene::Camera& camera, const scene::Frustum& frustum,
               platform::WorkerPool& workers, VisibleCells& visible);

/// Most cameras that cull together.
inline constexpr std::size_t kMaxTogether = 32;

/// cullCells() of several cameras in one walk over the cells. A cell that none of them sees is not examined. Each
/// camera gets the list that it would get alone.
/// @param tests at most kMaxTogether, a camera each. @param visible as many, overwritten.
void cullCells(const InstanceCells& cells, std::span<const SphereTest> tests, platform::WorkerPool& workers,
               std::span<VisibleCells* const> visible);

/// Appends the view distances [w - r, w + r] of every visible instance, in no particular order.
void appendIntervals(const VisibleCells& visible, std::vector<depth::Interval>& intervals);

} // namespace cdr::visibility
