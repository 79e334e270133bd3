#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/bin.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::visibility {

/// Who decides at which level of detail an instance is drawn.
enum class DetailMode : std::uint8_t {
    none,       ///< all in full: what measurements of depth use
    perObject,  ///< each instance by its own distance, one level in all cascades it straddles
    perCascade, ///< the cascade (thesis chapter 3): what straddles a boundary is drawn at two levels and may
                ///< crack
    perCluster, ///< each piece of a large mesh by its own distance, without cracks; other meshes as perObject
};

/// All of them.
inline constexpr std::array kDetailModes{DetailMode::none, DetailMode::perObject, DetailMode::perCascade,
                                         DetailMode::perCluster};

/// "none", "object", "cascade" or "cluster".
/// @lifetime The program's.
CDR_EXPORT std::string_view nameOf(DetailMode mode);

/// Level of detail by projected error.
struct Detail {
    DetailMode mode = DetailMode::none; ///< by which distance a level is chosen
    double pixels = 0.5; ///< largest error of a level on screen, in pixels at the middle of the picture, > 0

    bool operator==(const Detail&) const = default;
};

/// "none", "object:0.5", "cascade:0.5" or "cluster:0.5".
CDR_EXPORT std::string nameOf(const Detail& detail);
/// `none`, `object[:PIXELS]`, `cascade[:PIXELS]` or `cluster[:PIXELS]`.
/// @throws base::InputError for anything else, with a suggestion for an unknown name.
CDR_EXPORT Detail parseDetail(std::string_view text);
/// @throws base::InputError unless the pixels are finite and above 0.
CDR_EXPORT void requireUsable(const Detail& detail);

/// Makes what a mode chooses from, where meshes have none: levels, or clusters of large meshes and levels of the others. Takes
/// seconds for a million triangles.
CDR_EXPORT void prepareDetail(scene::Scene& scene, DetailMode mode, platform::WorkerPool& workers);

/// A Detail for one lens and picture.
struct LevelRule {
    DetailMode mode = DetailMode::none; ///< as Detail has it
    double slope = 0.0;                 ///< largest error per unit of view distance, both in scene units
};

/// The rule of a detail.
/// @param frustum of the picture, whose size in pixels it was made with.
CDR_EXPORT LevelRule levelRule(const Detail& detail, const scene::Frustum& frustum);

/// The coarsest level of an instance's mesh whose error, in world space, is at most `rule.slope` times the view distance of the
/// nearest point of its bounding sphere, w - r, but no nearer than the near plane. 0, the mesh itself, if no level's is, and
/// where all is drawn in full. Wherever the instance is, seen or not.
CDR_EXPORT std::uint8_t levelOf(const scene::Scene& scene, std::uint32_t instance,
                                const scene::Camera& camera, const LevelRule& rule);

/// Fills DrawLists::level. Of each draw it is the coarsest level whose error, in world space, is at most
/// `rule.slope` times a view distance. If no level's is, it is the mesh itself. With perObject and perCluster it is
/// levelOf() the instance. With perCascade the distance is the near end of the draw's cascade. Errors grow with an instance as its bounding sphere does. The levels are
/// the same for any number of workers.
/// @param lists of binByDistance() over the same camera and ranges.
CDR_EXPORT void chooseLevels(const scene::Scene& scene, const scene::Camera& camera,
                             const depth::Cascades& clipRanges, const LevelRule& rule,
                             platform::WorkerPool& workers, DrawLists& lists);

/// How many triangles the lists' draws have, counted once per cascade they are drawn in.
CDR_EXPORT std::uint64_t trianglesDrawn(const scene::Scene& scene, const DrawLists& lists);

} // namespace cdr::visibility
