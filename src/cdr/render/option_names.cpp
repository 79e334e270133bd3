#include <cdr/base/enum_names.h>
#include <cdr/render/effects.h>
#include <cdr/render/geometry/batching.h>
#include <cdr/render/geometry/snapping.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/submit/submission.h>
#include <cdr/render/surface_path.h>
#include <cdr/render/translucency/translucency.h>

namespace cdr::render {

namespace {

using base::EnumNames;

constexpr EnumNames<Antialias, kAntialiases.size()> kAntialiasNames{"antialiasing", {"none", "edges"}};
constexpr EnumNames<Batching, kBatchings.size()> kBatchingNames{
    "batching", {"per-object", "push-constants", "instanced"}};
constexpr EnumNames<ShadowMethod, kShadowMethods.size()> kShadowNames{"shadows",
                                                                      {"none", "anchored", "plain"}};
constexpr EnumNames<Snapping, kSnappings.size()> kSnappingNames{"snapping", {"by-device", "in-plane"}};
constexpr EnumNames<Submission, kSubmissions.size()> kSubmissionNames{
    "submission", {"secondaries", "primaries", "gpu-driven"}};
constexpr EnumNames<SurfacePath, kSurfacePaths.size()> kSurfaceNames{"surface",
                                                                     {"gbuffer", "visibility", "lit"}};
constexpr EnumNames<ToneMap, kToneMaps.size()> kToneMapNames{"tone mapping", {"scene", "none", "neutral"}};
constexpr EnumNames<Translucency, kTranslucencies.size()> kTranslucencyNames{"translucency",
                                                                             {"weighted", "sorted"}};

} // namespace

std::string_view nameOf(Antialias antialias) {
    return kAntialiasNames.nameOf(antialias);
}

Antialias parseAntialias(std::string_view name) {
    return kAntialiasNames.parse(name);
}

std::string_view nameOf(Batching batching) {
    return kBatchingNames.nameOf(batching);
}

Batching parseBatching(std::string_view name) {
    return kBatchingNames.parse(name);
}

std::string_view nameOf(ShadowMethod method) {
    return kShadowNames.nameOf(method);
}

ShadowMethod parseShadowMethod(std::string_view name) {
    return kShadowNames.parse(name);
}

std::string_view nameOf(Snapping snapping) {
    return kSnappingNames.nameOf(snapping);
}

Snapping parseSnapping(std::string_view name) {
    return kSnappingNames.parse(name);
}

std::string_view nameOf(Submission submission) {
    return kSubmissionNames.nameOf(submission);
}

Submission parseSubmission(std::string_view name) {
    return kSubmissionNames.parse(name);
}

std::string_view nameOf(SurfacePath path) {
    return kSurfaceNames.nameOf(path);
}

SurfacePath parseSurfacePath(std::string_view name) {
    return kSurfaceNames.parse(name);
}

std::string_view nameOf(ToneMap toneMap) {
    return kToneMapNames.nameOf(toneMap);
}

ToneMap parseToneMap(std::string_view name) {
    return kToneMapNames.parse(name);
}

std::string_view nameOf(Translucency translucency) {
    return kTranslucencyNames.nameOf(translucency);
}

Translucency parseTranslucency(std::string_view name) {
    return kTranslucencyNames.parse(name);
}

} // namespace cdr::render
