#include "verdict.h"

#include <cdr/scene/gltf/checks.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <output/readable.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cdr::experiments {

namespace {

/// Of a kind that sentences name; the table and JSON have all.
constexpr std::size_t kNamed = 5;

std::string shareText(double share) {
    return fmt::format("{} %", output::percent(share));
}

std::string both(const scene::Scene& scene, const ObjectPair& pair, const char* between) {
    return fmt::format("'{}' {} '{}'", nameOfObject(scene, pair.front), between,
                       nameOfObject(scene, pair.back));
}

std::string simplestLine(const Inspection& inspection) {
    const auto pixels = [&](const InspectedTechnique& each) {
        return fmt::format("{} of {} object pixels", each.wrong.wrong, inspection.objectPixels);
    };
    if (!inspection.couldJudge()) {
        return "No technique could be judged: no view shows a surface off edges that a technique can order.";
    }
    if (inspection.simplest) {
        const InspectedTechnique& simplest = inspection.techniques[*inspection.simplest];
        return fmt::format(
            "{} in {} is the simplest technique that is enough: {} are wrong.", nameOf(simplest),
            simplest.cascades == 1 ? "one cascade" : fmt::format("{} cascades", simplest.cascades),
            simplest.wrong.wrong == 0 ? "no pixels" : pixels(simplest));
    }
    // One whose order is undecided may have been lucky. Some of its undecided pixels are the wrong ones.
    const auto doubtful = [](const InspectedTechnique& each) {
        return std::max(static_cast<double>(each.wrong.wrong), each.undecided);
    };
    const auto best = std::ranges::min_element(inspection.techniques, {}, doubtful);
    const bool isUndecided = inspection.wrongFraction(*best) <= inspection.allowedShare;
    return fmt::format("No technique is enough: {} is the best, with {} wrong, {}{}.", nameOf(*best),
                       pixels(*best), shareText(inspection.wrongFraction(*best)),
                       isUndecided ? fmt::format(", but depth does not decide the order of {}",
                                                 shareText(inspection.undecidedFraction(*best)))
                                   : "");
}

/// What separates two coplanar faces, with how far apart techniques need them.
std::string remedyText(const ObjectPair& pair, const Inspection& inspection,
                       const depth::LengthText& lengthText) {
    std::vector<std::string> gaps;
    for (const InspectedTechnique& technique : inspection.techniques) {
        const auto found = technique.apart.find({pair.front, pair.back});
        if (found != technique.apart.end() && std::isfinite(found->second)) {
            const bool isUsual = technique.technique.format == depth::DepthFormat::d32f;
            gaps.push_back(fmt::format("{} for {}", lengthText(found->second),
                                       isUsual ? technique.name : nameOf(technique)));
        }
    }
    return gaps.empty() ? "move it, or give it a layer"
                        : fmt::format("move it by more than {}, or give it a layer of that size",
                                      fmt::join(gaps, " or "));
}

std::string coplanarLine(const ObjectPair& pair, const Inspection& inspection, const scene::Scene& scene,
                         const depth::LengthText& lengthText) {
    return fmt::format(
        "{} lie in one plane at {}: no technique separates them. Remove one, {} (cdr_layer in its extras).",
        both(scene, pair, "and"), lengthText(pair.atView), remedyText(pair, inspection, lengthText));
}

} // namespace

std::string nameOfObject(const scene::Scene& scene, std::uint32_t object) {
    const bool isNamed = object < scene.objectNames.size() && !scene.objectNames[object].empty();
    return isNamed ? scene::gltf::oneLine(scene.objectNames[object]) : fmt::format("object {}", object);
}

std::string nameOf(const InspectedTechnique& technique) {
    return fmt::format("{} with {}", technique.name, depth::nameOf(technique.technique.format));
}

std::vector<std::string> explain(const Inspection& inspection, const scene::Scene& scene,
                                 const depth::LengthText& lengthText) {
    std::vector<std::string> lines{simplestLine(inspection)};
    std::size_t coplanar = 0;
    std::size_t sunk = 0;
    const ObjectPair* nearest = nullptr;
    for (const ObjectPair& pair : inspection.pairs) {
        if (pair.isCoplanar()) {
            if (coplanar++ < kNamed) {
                lines.push_back(coplanarLine(pair, inspection, scene, lengthText));
            }
        } else if (pair.isSunk) {
            if (sunk++ < kNamed) {
                lines.push_back(
                    fmt::format("{} by {}, and no view shows it: it may be meant to lie in front.",
                                both(scene, {.front = pair.back, .back = pair.front}, "lies behind"),
                                lengthText(pair.gapView)));
            }
        } else if (nearest == nullptr) {
            nearest = &pair;
        }
    }
    if (nearest != nullptr) {
        lines.push_back(fmt::format("{} by {} at {}: this is the smallest gap for its distance.",
                                    both(scene, *nearest, "lies in front of"), lengthText(nearest->gapView),
                                    lengthText(nearest->atView)));
    }
    if (inspection.coplanarPixels > 0) {
        lines.push_back(fmt::format("{} lie in one plane, {} of the object pixels.",
                                    coplanar == 1 ? "Surfaces of one pair"
                                                  : fmt::format("Surfaces of {} pairs", coplanar),
                                    shareText(inspection.coplanarFraction())));
    }
    return lines;
}

} // namespace cdr::experiments
