#include "explanations.h"

#include <array>

namespace cdr::viewer {

namespace {

template <typename Enum, std::size_t N>
std::string_view at(const std::array<std::string_view, N>& texts, Enum value) {
    return texts.at(static_cast<std::size_t>(value));
}

} // namespace

std::string_view explanationOf(const depth::Split& split) {
    static constexpr std::array<std::string_view, std::variant_size_v<depth::Split>> kTexts{
        "One depth range from near to far. It is simple and cheap, but one precision has to serve all "
        "distances.",
        "Each cascade ends at a fixed multiple of where it begins, as in the thesis. It is even in "
        "relative terms, but does not know where the content is, so a boundary may cut through it.",
        "A fixed number of cascades of one ratio. The cost is known beforehand; the precision follows "
        "from near and far.",
        "Boundaries set by hand. They are right for a scene that you know, and wrong as soon as it "
        "moves.",
        "Cascades fitted to what is visible in each frame. They are the fewest whose steps stay under "
        "a target, with none over empty space. Objects must be found and sorted by distance on the "
        "CPU first.",
        "A fixed number of cascades, cut so that the largest step between near and far is as small as "
        "possible. It is even in scene units, at the expense of what is near."};
    return kTexts.at(split.index());
}

std::string_view explanationOf(depth::DepthFormat format) {
    static constexpr std::array<std::string_view, depth::kDepthFormats.size()> kTexts{
        "16 bits of fraction. It takes half the memory traffic, and has 65,536 depths in all, enough for one "
        "thin cascade.",
        "24 bits of fraction: 16.7 million evenly spaced depths. It is common on desktops, and missing on "
        "some devices.",
        "A 32-bit float. It has 24 bits near 1 and is finer towards 0, which the reversed mappings use. "
        "Every device has it."};
    return at(kTexts, format);
}

std::string_view explanationOf(render::Submission submission) {
    static constexpr std::array<std::string_view, render::kSubmissions.size()> kTexts{
        "Workers record secondary command buffers and one primary executes them. Recording scales with "
        "threads.",
        "Workers record whole primary command buffers, which are submitted at once. It is the control, "
        "without the cost of secondaries.",
        "Compute passes on the device cull, bin and write the draws, so the CPU hardly records at all. On a "
        "software device those passes compete with drawing."};
    return at(kTexts, submission);
}

std::string_view explanationOf(render::Batching batching) {
    static constexpr std::array<std::string_view, render::kBatchings.size()> kTexts{
        "One draw per object, with its record as an instance attribute, as engines without instancing "
        "submit.",
        "One draw per object, with its record in push constants, as small engines do. It takes twice the "
        "time on lavapipe.",
        "Runs of one mesh and material become one instanced draw. It takes the fewest commands, and the "
        "picture is the same."};
    return at(kTexts, batching);
}

std::string_view explanationOf(render::Snapping snapping) {
    static constexpr std::array<std::string_view, render::kSnappings.size()> kTexts{
        "The device rounds vertices to sub-pixels and keeps their depth, so slanted triangles tilt a little.",
        "Vertices of flat facets move to their sub-pixel in the plane of the facet first, so depth stays exact."};
    return at(kTexts, snapping);
}

std::string_view explanationOf(visibility::DetailMode detail) {
    static constexpr std::array<std::string_view, visibility::kDetailModes.size()> kTexts{
        "Every mesh in full. It is slow where they are dense and small.",
        "Each object at the coarsest level whose error stays under its limit, by default half a pixel. The level "
        "is the same in all its cascades, so there are no cracks.",
        "Each cascade chooses, as in the thesis. An object that crosses a boundary is drawn at two levels, "
        "which may leave cracks.",
        "Each piece of a large mesh at a level of its own, by its distance. Near parts are fine and far ones "
        "coarse, without cracks. Small meshes are drawn by object."};
    return at(kTexts, detail);
}

std::string_view explanationOf(render::Translucency translucency) {
    return translucency == render::Translucency::weighted
               ? "Blended surfaces of a cascade are averaged by weight, and cascades are composited. It is "
                 "fast, and approximate where surfaces overlap."
               : "Every blended fragment is kept, sorted by its distance and composited. It is exact, but "
                 "takes memory.";
}

std::string_view explanationOf(render::ShadowMethod shadows) {
    static constexpr std::array<std::string_view, render::kShadowMethods.size()> kTexts{
        "There are no shadows.",
        "The first four lights cast shadows, each by a map for every range of distances that is seen. There "
        "are none with a focus, nor with levels of detail by cascade or cluster.",
        "Today's practice: four maps for each light, for any distances. There are none with a focus, nor with "
        "levels of detail by cascade or cluster."};
    return at(kTexts, shadows);
}

std::string_view explanationOf(render::Antialias antialias) {
    return antialias == render::Antialias::none
               ? "Pixels as they were sampled, as measurements use them."
               : "Steps along edges of brightness are smoothed after shading.";
}

std::string_view explanationOf(render::ToneMap toneMap) {
    static constexpr std::array<std::string_view, render::kToneMaps.size()> kTexts{
        "Highlights are compressed under a sky, which models have, or through air. Otherwise they are cut "
        "off.",
        "What is brighter than the picture's white is cut off.",
        "Highlights are compressed, and base colours stay as they are (Khronos PBR Neutral)."};
    return at(kTexts, toneMap);
}

std::string_view explanationOf(const render::Occlusion& occlusion) {
    if (occlusion.radius <= 0.0) {
        return "Corners get as much ambient light as open ground.";
    }
    return occlusion.perLayer
               ? "Corners lose ambient light, on each cascade alone (thesis method 2). Surfaces in "
                 "another cascade do not darken them. It needs layered targets."
               : "Corners lose ambient light, by distances that all cascades share. So no boundary is "
                 "visible.";
}

std::string_view explanationOf(const render::Fog& fog) {
    return fog.visibility <= 0.0 ? "Clear air." : "At this distance 2 % of a colour is left.";
}

std::string_view explanationOf(const render::Focus& focus) {
    if (!focus.isOn()) {
        return "Everything is sharp. With the targets layers a lens can be focused on a distance.";
    }
    return focus.blend ? "What is out of focus is drawn in fewer pixels, cascade by cascade. Cascades that "
                         "meet fade into each other."
                       : "What is out of focus is drawn in fewer pixels, cascade by cascade, as the thesis "
                         "proposes. A seam is visible where cascades meet.";
}

std::string_view explanationOf(ViewKind view) {
    static constexpr std::array<std::string_view, kViewKinds.size()> kTexts{
        "The lit picture, as a user of the scene would see it.",
        "Each pixel is tinted by the cascade that drew it. It shows where the boundaries are and what each "
        "cascade covers.",
        "Brightness by view distance, on a logarithmic scale from the nearest surface, white, to the "
        "farthest. It shows depth order, not precision.",
        "A colour for each object. Where the pixels of two colours are mixed, depth does not resolve the "
        "objects.",
        "Red where another object is shown than in the anchored answer of the same view, off edges; orange "
        "on edges, where rasterisation decides. It is compared with anchored, not with the exact ray cast of "
        "the experiments.",
        "Red where a pixel flips: off edges, its true object stays from one frame to the next while the "
        "drawn one changes. The anchored answer stands for the truth. Red fades over a second, and nothing "
        "is shown while the camera rests."};
    return at(kTexts, view);
}

std::string_view explainThreads() {
    return "Threads that cull, bin and record; the picture is the same to the bit for any number. They "
           "shorten recording, not drawing.";
}

} // namespace cdr::viewer
