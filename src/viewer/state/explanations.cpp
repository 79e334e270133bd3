#include "explanations.h"

#include <array>

namespace cdr::viewer {

namespace {

template <typename Enum, std::size_t N>
std::string_view at(const std::array<std::string_view, N>& texts, Enum value) {
    return texts.at(static_cast<std::size_t>(value));
}

struct ExplainSplit {
    std::string_view operator()(const depth::SplitNone&) const {
        return "One depth range from near to far: simple and cheap, and all its precision has to do for "
               "everything.";
    }
    std::string_view operator()(const depth::SplitRatio&) const {
        return "Each cascade reaches a fixed ratio farther than it begins, as in the thesis: even in "
               "relative "
               "terms, blind to where the content is, so a boundary may run right through it.";
    }
    std::string_view operator()(const depth::SplitCount&) const {
        return "A fixed number of cascades of one ratio: the cost is known beforehand, the precision follows "
               "from near and far.";
    }
    std::string_view operator()(const depth::SplitAt&) const {
        return "Boundaries set by hand: right for a scene you know, wrong as soon as it moves.";
    }
    std::string_view operator()(const depth::SplitFitted&) const {
        return "Cascades fitted to what is visible in each frame: the fewest whose steps stay under a "
               "target, "
               "and none over empty space; objects must be found and sorted by distance on the CPU first.";
    }
    std::string_view operator()(const depth::SplitMinimax&) const {
        return "A fixed number of cascades, cut so that the worst step between near and far is the smallest "
               "possible: even in scene units, at the expense of what is near.";
    }
};

} // namespace

std::string_view explain(depth::Mapping mapping) {
    static constexpr std::array<std::string_view, depth::kMappings.size()> kTexts{
        "Ordinary perspective depth: works on all hardware, but spends nearly all of its precision right in "
        "front of the camera.",
        "Near over distance, stored in a float: the float's own steps even perspective out, so the relative "
        "precision is equal everywhere; what most engines ship. It ends where float32 positions do, at about "
        "a "
        "ten-millionth of the distance.",
        "The logarithm of the distance, set at each vertex: equal relative precision in any format, but bent "
        "wrongly across triangles that are long for their distance.",
        "The logarithm of the distance, set at each pixel: right on every triangle, at the price of the "
        "early "
        "depth test.",
        "Depth from the cascade's near plane, whose distance is taken off in float64 on the CPU: float32 "
        "then "
        "rounds the way to that plane and not to the camera, so it resolves micrometres at any distance. One "
        "subtraction per object and cascade, and cascades must be thin.",
        "The same from the cascade's far plane, finest at its far end: for detail on a backdrop or on the "
        "ground below; with a float buffer it needs fewer cascades to hold one step over a wide range."};
    return at(kTexts, mapping);
}

std::string_view explain(const depth::Split& split) {
    return std::visit(ExplainSplit{}, split);
}

std::string_view explain(depth::DepthFormat format) {
    static constexpr std::array<std::string_view, depth::kDepthFormats.size()> kTexts{
        "16 bits of fraction: half the memory traffic, and 65,536 distances in all, enough for one thin "
        "cascade.",
        "24 bits of fraction: 16.7 million evenly spaced depths; common on desktops, missing on some "
        "devices.",
        "A 32-bit float: 24 bits near 1 and finer towards 0, which the reversed mappings turn to use; there "
        "on "
        "every device."};
    return at(kTexts, format);
}

std::string_view explain(render::TargetsKind targets) {
    static constexpr std::array<std::string_view, render::kTargetsKinds.size()> kTexts{
        "One G-buffer for all cascades, drawn from the farthest to the nearest with depth cleared in between "
        "(the thesis' method 1): the least memory, no merging, but what is hidden by a nearer cascade is "
        "drawn "
        "too.",
        "Each cascade is drawn into a layer and merged into an accumulated G-buffer (method 2): an effect "
        "may "
        "run on each layer, at the price of one merge per cascade.",
        "Several layers in flight and merged in depth order (method 3): cascades need not wait for each "
        "other's merge; memory for each layer.",
        "One G-buffer per cascade, all kept and merged at the end (method 4): everything behind stays to be "
        "used, and takes the most memory.",
        "One rendering scope without clears, each cascade in its own slice of the depth range, nearest "
        "first: "
        "early depth tests work across cascades; integer formats pay with a bit per doubling of cascades."};
    return at(kTexts, targets);
}

std::string_view explain(render::Submission submission) {
    static constexpr std::array<std::string_view, render::kSubmissions.size()> kTexts{
        "Workers record secondary command buffers and one primary executes them: recording scales with "
        "threads.",
        "Workers record whole primary command buffers, submitted at once: the control, without what "
        "secondaries cost.",
        "Compute passes on the device cull, bin and write the draws: the CPU hardly records at all; on a "
        "software device those passes compete with drawing."};
    return at(kTexts, submission);
}

std::string_view explain(render::Batching batching) {
    static constexpr std::array<std::string_view, render::kBatchings.size()> kTexts{
        "One draw per object, its record an instance attribute: what engines without instancing submit.",
        "One draw per object, its record pushed before it: what small engines do, and twice the time on "
        "lavapipe.",
        "Runs of one mesh and material become one instanced draw: the fewest commands, the same picture."};
    return at(kTexts, batching);
}

std::string_view explain(ViewKind view) {
    static constexpr std::array<std::string_view, kViewKinds.size()> kTexts{
        "The lit picture, as a user of the scene would see it.",
        "Each pixel tinted by the cascade that drew it: shows where the boundaries run and what each one "
        "covers.",
        "Brightness by view distance, on a logarithmic scale from the nearest surface, white, to the "
        "farthest: "
        "shows depth order, not precision.",
        "A colour for each object: where two colours are mixed like gravel, depth cannot tell them apart.",
        "Red where another object shows than in the anchored answer of the same view, off edges; orange on "
        "edges, where rasterisation decides. The answer is anchored's, not the exact ray cast of the "
        "experiments.",
        "Red where a pixel flips: off edges, its true object stays from one frame to the next while the drawn "
        "one changes. The anchored answer stands for the truth. Red fades over a second, and nothing shows "
        "while the camera rests."};
    return at(kTexts, view);
}

std::string_view explainThreads() {
    return "Threads that cull, bin and record; the picture is the same to the bit for any number. They "
           "shorten "
           "recording, not drawing.";
}

} // namespace cdr::viewer
