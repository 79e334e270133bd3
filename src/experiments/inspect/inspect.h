#pragma once

#include "pairs.h"

#include <cdr/depth/forecast.h>
#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/scene.h>
#include <experiments/pictures/pictures.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::experiments {

/// What to look at a scene with.
struct InspectOptions {
    render::RenderOptions drawing{}; ///< but for the technique
    std::vector<depth::NamedTechnique>
        techniques;               ///< all presets when empty, each in every format that the device has
    double allowedShare = 0.0;    ///< of object pixels that may be wrong, and that may be undecided
    depth::NamedTechnique judged; ///< whose wrong pixels the heat map shows; one of them, or one more
};

/// One technique in one format, over all views. Pixels that show two surfaces in one plane, blended ones too, are left out.
struct InspectedTechnique {
    std::string name;
    depth::Technique technique;
    std::size_t cascades = 0;     ///< most in a view
    measure::WrongPixels wrong{}; ///< as rendered
    // Of the inner pixels, as cdr::depth expects in the cascades that were cut:
    double undecided = 0.0;      ///< whose order depth does not tell
    double predictedWrong = 0.0; ///< that show the farther surface
    /// How far two coplanar objects must be apart at each of their pixels, so that no rounding decides; by object index, the
    /// lower first. For judged, `reversed` and `anchored` in `d32f`.
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> apart{};
    bool isJudged = false;

    double predictedFraction() const { return shareOf(predictedWrong); }
    double undecidedFraction() const { return shareOf(undecided); }
    double shareOf(double pixels) const {
        return wrong.pixels ? pixels / static_cast<double>(wrong.pixels) : 0.0;
    }
};

struct Inspection {
    std::vector<ObjectPair> pairs;              ///< nearest to each other first
    std::vector<InspectedTechnique> techniques; ///< simplest first, or in the order of the options
    std::size_t judged = 0;                     ///< index of it
    std::optional<std::size_t> simplest{}; ///< the first with no more wrong and undecided pixels than allowed
    double allowedShare = 0.0;             ///< InspectOptions::allowedShare
    std::uint64_t objectPixels = 0;        ///< that show an object, edges too
    std::uint64_t coplanarPixels = 0; ///< of them, two of whose surfaces lie in one plane; none is judged
    image::ImageRgba8 heatMap{}; ///< of the worst view: red wrong, orange wrong on an edge, magenta coplanar

    double coplanarFraction() const { return shareOf(static_cast<double>(coplanarPixels)); }
    /// Whether a view shows surfaces off edges that some technique could order.
    bool couldJudge() const { return techniques[judged].wrong.pixels > 0; }
    /// Share of the object pixels that the judged technique gets wrong, off edges.
    double wrongFraction() const { return wrongFraction(techniques[judged]); }
    /// The same of any technique: by it and by undecidedFraction() a technique suffices.
    double wrongFraction(const InspectedTechnique& each) const {
        return shareOf(static_cast<double>(each.wrong.wrong));
    }
    /// Share of the object pixels whose order depth does not tell.
    double undecidedFraction(const InspectedTechnique& each) const { return shareOf(each.undecided); }
    /// Share of the object pixels that the judged technique gets wrong or that no technique gets right.
    double badFraction() const {
        return shareOf(static_cast<double>(techniques[judged].wrong.wrong + coplanarPixels));
    }
    double shareOf(double pixels) const {
        return objectPixels ? pixels / static_cast<double>(objectPixels) : 0.0;
    }
};

/// Casts the truth of every view and renders each technique from there. base::InputError as TruthCaster and Renderer.
/// @param cameras at least one.
Inspection runInspect(const gpu::Device& device, const scene::Scene& scene,
                      const std::vector<scene::Camera>& cameras, const InspectOptions& options,
                      const NamedProgress& progress);

/// What a depth buffer makes of two surfaces, as probabilities. They fall with the gap over what the buffer and float32
/// round.
struct OrderChance {
    double undecided = 0.0; ///< depth does not say which is nearer: rounding or the order of drawing does
    double wrong =
        0.0; ///< the farther one shows: what is drawn later, where the buffer stores one number for both
};

/// Which of two surfaces is drawn later.
enum class DrawnLater : std::uint8_t { nearer, farther };

/// For surfaces that are `gapView` apart where the forecast holds; nothing: in no cascade.
OrderChance orderChance(const std::optional<depth::Forecast>& forecast, double gapView, DrawnLater later);

} // namespace cdr::experiments
