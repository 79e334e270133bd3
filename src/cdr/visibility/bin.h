#pragma once

/// @file
/// @errors None: what is wanted of arguments is not checked.

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/visibility/cull.h>

#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// Neighbouring clusters of a mesh: a run of scene::ClusterTree::indices.
struct ClusterRun {
    std::uint32_t firstIndex = 0; ///< into scene::ClusterTree::indices
    std::uint32_t indexCount = 0; ///< 0: no clusters, but the mesh at a level

    bool operator==(const ClusterRun&) const = default;
};

/// What each cascade draws, nearest cascade first. Within a cascade the compact instances come first, then
/// the wide ones, each in instance order.
struct DrawLists {
    std::vector<std::uint32_t> instance; ///< cascade by cascade
    /// Bucket 2c holds cascade c's compact instances, bucket 2c + 1 its wide ones; bucket b is the entries
    /// [begins[b], begins[b + 1]) of `instance`.
    std::vector<std::size_t> begins{0};
    std::size_t visible = 0; ///< instances in at least one cascade

    /// Where a visible instance lands: in `cascades` cascades from that of `bucket` on.
    struct Landing {
        std::uint16_t bucket = 0;   ///< of the first cascade
        std::uint16_t cascades = 0; ///< how many follow one another
    };
    /// By entry of `instance`: the level of detail it is drawn at (chooseLevels()); empty where all are drawn
    /// in full.
    std::vector<std::uint8_t> level;
    /// By entry of `instance`: the clusters of its mesh that are drawn (chooseClusters()); empty where none has any.
    std::vector<ClusterRun> runs;

    std::vector<Landing> landings; ///< scratch of binByDistance(), by index into the visible list

    /// How many cascades there are.
    std::size_t cascades() const { return begins.size() / 2; }
    /// How many entries all lists have.
    std::size_t draws() const { return begins.back(); }
    /// The entries of a cascade.
    platform::IndexRange range(std::size_t cascade) const {
        return {begins[2 * cascade], begins[2 * cascade + 2]};
    }
    /// Where the wide instances of a cascade begin.
    std::size_t wideBegin(std::size_t cascade) const { return begins[2 * cascade + 1]; }
    /// The ratio of draws to visible instances: 1 where no instance straddles a boundary.
    double duplication() const {
        return visible ? static_cast<double>(draws()) / static_cast<double>(visible) : 1.0;
    }
};

/// Empties the lists of all other cascades; before levels are chosen. `visible` stays.
CDR_EXPORT void keepCascades(DrawLists& lists, platform::IndexRange cascades);

/// Puts every visible instance into each cascade whose range its sphere [w - r, w + r] meets (thesis chapter
/// 3). The same lists for any number of workers. `lists` is reused, so binning allocates nothing once warm.
/// @param clipRanges each cascade's depth::clipRange(), at most depth::kMaxCascades, nearest first: near planes
///        ascend. A range that ends before an earlier one does is taken to end with it.
/// @param wideSpan a ratio: an instance is wide when its sphere reaches the camera plane or 2r > wideSpan * (w - r);
///        infinity for none. Depth that is not linear in screen space must be set per fragment on those.
CDR_EXPORT void binByDistance(const VisibleList& visible, const depth::Cascades& clipRanges, double wideSpan,
                              platform::WorkerPool& workers, DrawLists& lists);

} // namespace cdr::visibility
