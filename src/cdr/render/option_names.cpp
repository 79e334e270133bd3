#include <cdr/base/enum_names.h>
#include <cdr/render/effects.h>
#include <cdr/render/geometry/batching.h>
#include <cdr/render/geometry/snapping.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/submit/submission.h>
#include <cdr/render/surface_path.h>
#include <cdr/render/translucency/translucency.h>

namespace cdr::render {

/// Defines nameOf() and the parser of an option. The list of its values, what messages call one, and their names follow.
#define CDR_OPTION_NAMES(Option, list, what, ...)                                                            \
    static constexpr base::EnumNames<Option, (list).size()> k##Option##Names{what, {__VA_ARGS__}};           \
    std::string_view nameOf(Option option) {                                                                 \
        return k##Option##Names.nameOf(option);                                                              \
    }                                                                                                        \
    Option parse##Option(std::string_view name) {                                                            \
        return k##Option##Names.parse(name);                                                                 \
    }

CDR_OPTION_NAMES(Antialias, kAntialiases, "antialiasing", "none", "edges")
CDR_OPTION_NAMES(Batching, kBatchings, "batching", "per-object", "push-constants", "instanced")
CDR_OPTION_NAMES(ShadowMethod, kShadowMethods, "shadows", "none", "anchored", "plain")
CDR_OPTION_NAMES(Snapping, kSnappings, "snapping", "by-device", "in-plane")
CDR_OPTION_NAMES(Submission, kSubmissions, "submission", "secondaries", "primaries", "gpu-driven")
CDR_OPTION_NAMES(SurfacePath, kSurfacePaths, "surface", "gbuffer", "visibility", "lit")
CDR_OPTION_NAMES(ToneMap, kToneMaps, "tone mapping", "scene", "none", "neutral")
CDR_OPTION_NAMES(Translucency, kTranslucencies, "translucency", "weighted", "sorted")

#undef CDR_OPTION_NAMES

} // namespace cdr::render
