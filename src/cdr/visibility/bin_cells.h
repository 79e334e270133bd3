#pragma once

#include <cdr/visibility/bin.h>
#include <cdr/visibility/cull_cells.h>
#include <cdr/visibility/instance_bags.h>
#include <cdr/visibility/instance_sets.h>
#include <cdr/visibility/landings.h>

#include <vector>

namespace cdr::visibility {

/// Puts visible instances into cascades. It keeps its memory, so that binning allocates nothing once warm.
class CellBinner {
  public:
    /// The lists that binByDistance() makes of what cullSpheres() keeps, for any number of workers. Cells whose
    /// instances are all in the same cascades are not examined. Where it throws, the next time is as if it were the first.
    void bin(const VisibleCells& visible, const depth::Cascades& clipRanges, double wideSpan,
             platform::WorkerPool& workers, DrawLists& lists);

  private:
    void binMany(const VisibleCells& visible, const LandingRanges& ranges, platform::WorkerPool& workers,
                 DrawLists& lists);
    void drain(platform::WorkerPool& workers, DrawLists& lists);
    void binFew(const VisibleCells& visible, const LandingRanges& ranges, platform::WorkerPool& workers,
                DrawLists& lists);

    std::vector<InstanceSets> m_sets; ///< by worker
    std::vector<InstanceBags> m_bags; ///< by worker
    bool m_isBinning = false;         ///< else both are empty
};

} // namespace cdr::visibility
