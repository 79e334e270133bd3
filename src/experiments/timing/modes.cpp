#include "timing.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace cdr::experiments {

namespace {

constexpr unsigned kLeastCascades = 2;
constexpr unsigned kMostCascades = 5;

/// Section 6.2: CDR and LogCDR with two to five divisions.
constexpr double kThesisCdr[] = {3.4, 4.6, 5.7, 7.1};
constexpr double kThesisLog = 4.4;
constexpr double kThesisLogCdr[] = {8.0, 8.2, 8.4, 10.4};

TimingMode makeMode(std::string name, const char* preset, std::optional<double> thesisPercent) {
    TimingMode mode;
    mode.name = std::move(name);
    mode.preset = preset;
    mode.technique = depth::parseTechnique(preset);
    mode.thesisPercent = thesisPercent;
    return mode;
}

void addCascaded(const char* preset, const double (&thesis)[kMostCascades - kLeastCascades + 1],
                 std::vector<TimingMode>& modes) {
    for (unsigned count = kLeastCascades; count <= kMostCascades; ++count) {
        modes.push_back(makeMode(std::string(preset) + "-" + std::to_string(count), preset,
                                 thesis[count - kLeastCascades]));
        modes.back().technique.split = depth::SplitCount{count};
    }
}

/// Nothing where this build has no targets of that name.
std::optional<render::TargetsChoice> targetsIfKnown(std::string_view name) {
    try {
        return render::parseTargets(name);
    } catch (const base::InputError&) {
        return std::nullopt;
    }
}

} // namespace

render::RenderOptions renderOptionsOf(const TimingMode& mode) {
    return {.technique = mode.technique,
            .targets = mode.targets,
            .submission = mode.submission,
            .batching = mode.batching,
            .surface = mode.surface,
            .snapping = mode.snapping,
            .occlusionCulling = mode.occlusionCulling};
}

std::vector<TimingMode> timingModes() {
    const TimingMode standard = makeMode("standard", "standard", std::nullopt);
    std::vector<TimingMode> modes{standard, standard};
    modes[1].name = "standard-again";
    addCascaded("cdr", kThesisCdr, modes);
    modes.push_back(makeMode("log", "log", kThesisLog));
    addCascaded("logcdr", kThesisLogCdr, modes);
    modes.push_back(makeMode("reversed", "reversed", std::nullopt));
    modes.push_back(makeMode("anchored", "anchored", std::nullopt));
    if (const auto onePass = targetsIfKnown("one-pass")) {
        std::vector<TimingMode> again(modes.begin() + 1, modes.end());
        again.front() = standard;
        for (TimingMode& mode : again) {
            mode.name += "/one-pass";
            mode.targets = *onePass;
            mode.thesisPercent.reset(); // the thesis has no such method
        }
        std::move(again.begin(), again.end(), std::back_inserter(modes));
    }
    return modes;
}

std::vector<TimingMode> extraTimingModes() {
    std::vector<TimingMode> modes;
    const auto add = [&](const std::string& name, const char* technique, auto change) {
        TimingMode mode = makeMode(name, technique, std::nullopt);
        change(mode);
        modes.push_back(std::move(mode));
    };
    add("naive", "standard", [](TimingMode& mode) {
        mode.batching = render::Batching::perObject;
        mode.meshes = TimingMeshes::unshared;
    });
    add("log-fragment", "log", [](TimingMode& mode) {
        mode.technique.mapping = depth::Mapping::logFragment;
        mode.preset = partsOf(mode.technique);
    });
    for (const char* technique : {"standard", "reversed", "anchored"}) {
        const std::string prefix = std::string(technique) + "/";
        for (const render::Batching batching :
             {render::Batching::perObject, render::Batching::pushConstants}) {
            add(prefix + std::string(nameOf(batching)), technique,
                [&](TimingMode& mode) { mode.batching = batching; });
        }
        for (const render::SurfacePath surface :
             {render::SurfacePath::visibility, render::SurfacePath::lit}) {
            add(prefix + std::string(nameOf(surface)), technique,
                [&](TimingMode& mode) { mode.surface = surface; });
        }
        add(prefix + std::string(nameOf(render::Snapping::inPlane)), technique,
            [](TimingMode& mode) { mode.snapping = render::Snapping::inPlane; });
        add(prefix + "occlusion-culling", technique, [](TimingMode& mode) { mode.occlusionCulling = true; });
        for (const render::Submission submission :
             {render::Submission::primaries, render::Submission::gpuDriven}) {
            add(prefix + std::string(nameOf(submission)), technique,
                [&](TimingMode& mode) { mode.submission = submission; });
        }
    }
    return modes;
}

std::vector<TimingMode> rivalTimingModes(const std::vector<rivals::NamedRival>& rivals) {
    std::vector<TimingMode> modes;
    if (!rivals.empty()) {
        modes.push_back(makeMode("standard/ids", "standard", std::nullopt));
        modes.back().idsAlone = modes.back().technique;
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
    std::vector<TimingMode> all = timingModes();
    std::vector<TimingMode> extra = extraTimingModes();
    std::move(extra.begin(), extra.end(), std::back_inserter(all));
    std::vector<std::string_view> known;
    for (const TimingMode& mode : all) {
        known.push_back(mode.name);
    }
    std::vector<TimingMode> chosen(all.begin(), all.begin() + 2);
    for (const std::string& name : names) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end()) {
            throw base::InputError(base::unknownName("mode", name, known));
        }
        if (found - known.begin() >= 2) {
            chosen.push_back(all[static_cast<std::size_t>(found - known.begin())]);
        }
    }
    return chosen;
}

} // namespace cdr::experiments
