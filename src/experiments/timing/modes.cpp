#include "timing.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string_view>
#include <utility>

namespace cdr::experiments {

namespace {

constexpr unsigned kMinCascades = 2;
constexpr unsigned kMaxCascades = 5;

/// Section 6.2: CDR and LogCDR with two to five divisions.
constexpr double kThesisCdr[] = {3.4, 4.6, 5.7, 7.1};
constexpr double kThesisLog = 4.4;
constexpr double kThesisLogCdr[] = {8.0, 8.2, 8.4, 10.4};

TimingMode makeMode(std::string name, const char* preset, std::optional<double> thesisPercent) {
    TimingMode mode;
    mode.name = std::move(name);
    mode.preset = preset;
    mode.drawing.technique = depth::parseTechnique(preset);
    mode.thesisPercent = thesisPercent;
    return mode;
}

void addCascaded(const char* preset, const double (&thesis)[kMaxCascades - kMinCascades + 1],
                 std::vector<TimingMode>& modes) {
    for (unsigned count = kMinCascades; count <= kMaxCascades; ++count) {
        modes.push_back(makeMode(std::string(preset) + "-" + std::to_string(count), preset,
                                 thesis[count - kMinCascades]));
        modes.back().drawing.technique.split = depth::SplitCount{count};
    }
}

/// What a word behind a technique changes, such as "/gpu-driven".
struct ModeVariant {
    std::string_view word;
    std::string_view option; ///< that it is a value of
    std::function<void(TimingMode&)> change;
};

/// A variant for each of an option's values but that of plain modes.
template <typename Choice, std::size_t Count>
void addChoices(std::string_view name, const std::array<Choice, Count>& choices,
                Choice render::RenderOptions::*option, std::vector<ModeVariant>& variants) {
    static const render::RenderOptions kPlain;
    for (const Choice choice : choices) {
        if (choice != kPlain.*option) {
            variants.push_back(
                {nameOf(choice), name, [=](TimingMode& mode) { mode.drawing.*option = choice; }});
        }
    }
}

std::vector<ModeVariant> allVariants() {
    std::vector<ModeVariant> variants{{"occlusion-culling", "occlusion culling",
                                       [](TimingMode& mode) { mode.drawing.occlusionCulling = true; }}};
    addChoices("batching", render::kBatchings, &render::RenderOptions::batching, variants);
    addChoices("submission", render::kSubmissions, &render::RenderOptions::submission, variants);
    addChoices("surface", render::kSurfacePaths, &render::RenderOptions::surface, variants);
    addChoices("snapping", render::kSnappings, &render::RenderOptions::snapping, variants);
    for (const render::TargetsKind kind : render::kTargetsKinds) {
        if (kind != render::TargetsKind::single) {
            variants.push_back(
                {nameOf(kind), "targets", [=](TimingMode& mode) { mode.drawing.targets = kind; }});
        }
    }
    return variants;
}

/// What of a list has a name. base::InputError with a suggestion for one that nothing has.
template <typename Named, typename NameOf>
const Named& namedOf(const char* what, const std::vector<Named>& all, std::string_view name,
                     const NameOf& nameOfOne) {
    std::vector<std::string_view> known;
    for (const Named& one : all) {
        known.push_back(nameOfOne(one));
    }
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
        throw base::InputError(base::unknownName(what, name, known));
    }
    return all[static_cast<std::size_t>(found - known.begin())];
}

/// All that may stand in front of variants.
std::vector<TimingMode> plainModes() {
    std::vector<TimingMode> modes{makeMode("standard", "standard", std::nullopt)};
    addCascaded("cdr", kThesisCdr, modes);
    modes.push_back(makeMode("log", "log", kThesisLog));
    addCascaded("logcdr", kThesisLogCdr, modes);
    modes.push_back(makeMode("reversed", "reversed", std::nullopt));
    modes.push_back(makeMode("anchored", "anchored", std::nullopt));
    return modes;
}

void vary(TimingMode& mode, const ModeVariant& variant) {
    mode.name += "/" + std::string(variant.word);
    variant.change(mode);
    mode.thesisPercent.reset(); // the thesis draws in one way alone
}

TimingMode modeNamed(std::string_view name) {
    std::vector<TimingMode> plain = plainModes();
    plain.push_back(makeMode("naive", "standard", std::nullopt));
    plain.back().drawing.batching = render::Batching::perObject;
    plain.back().meshes = TimingMeshes::unshared;
    plain.push_back(makeMode("log-fragment", "log", std::nullopt));
    plain.back().drawing.technique.mapping = depth::Mapping::logFragment;
    plain.back().preset = partsOf(plain.back().drawing.technique);

    std::size_t end = std::min(name.find('/'), name.size());
    TimingMode mode = namedOf("mode", plain, name.substr(0, end),
                              [](const TimingMode& one) { return std::string_view(one.name); });
    const std::vector<ModeVariant> variants = allVariants();
    std::set<std::string_view> options;
    while (end < name.size()) {
        name.remove_prefix(end + 1);
        end = std::min(name.find('/'), name.size());
        const ModeVariant& variant = namedOf("variant of a mode", variants, name.substr(0, end),
                                             [](const ModeVariant& one) { return one.word; });
        vary(mode, variant);
        if (!options.insert(variant.option).second) {
            throw base::InputError("mode " + mode.name + " has more than one " + std::string(variant.option));
        }
    }
    return mode;
}

} // namespace

std::vector<TimingMode> timingModes() {
    const std::vector<TimingMode> plain = plainModes();
    std::vector<TimingMode> modes{plain.front()};
    for (const TimingMode& mode : plain) {
        modes.push_back(mode);
    }
    modes[1].name = "standard-again";
    const std::vector<ModeVariant> variants = allVariants();
    const ModeVariant& onePass = namedOf("variant of a mode", variants, nameOf(render::TargetsKind::onePass),
                                         [](const ModeVariant& one) { return one.word; });
    for (const TimingMode& mode : plain) {
        vary(modes.emplace_back(mode), onePass);
    }
    return modes;
}

std::vector<TimingMode> rivalTimingModes(const std::vector<rivals::NamedRival>& rivals) {
    std::vector<TimingMode> modes;
    if (!rivals.empty()) {
        modes.push_back(makeMode("standard/ids", "standard", std::nullopt));
        modes.back().idsAlone = modes.back().drawing.technique;
    }
    for (const auto& [name, rival] : rivals) {
        TimingMode& mode = modes.emplace_back();
        mode.name = name;
        mode.preset = name;
        mode.idsAlone = rival;
    }
    return modes;
}

std::vector<TimingMode> timingModesNamed(const std::vector<std::string>& names) {
    const std::vector<TimingMode> all = timingModes();
    std::vector<TimingMode> chosen(all.begin(), all.begin() + 2);
    for (const std::string& name : names) {
        if (name == chosen[0].name || name == chosen[1].name) {
            continue; // always measured
        }
        if (std::ranges::any_of(chosen, [&](const TimingMode& mode) { return mode.name == name; })) {
            throw base::InputError("mode " + name + " is given twice");
        }
        chosen.push_back(modeNamed(name));
    }
    return chosen;
}

} // namespace cdr::experiments
