#include "choice.h"
#include "panels.h"
#include "thumbnails.h"

#include <viewer/state/importer_notes.h>
#include <viewer/state/light_list.h>
#include <viewer/state/plain_words.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace cdr::viewer {

namespace {

/// Splits that the panel offers. The current one is listed too.
constexpr std::array<std::string_view, 8> kSplits{"none",    "ratio:1000", "ratio:30",  "count:2",
                                                  "count:4", "count:8",    "minimax:4", "fitted"};

constexpr int kMaxThreads = 16;

void choosePresets(const Widgets& widgets, std::string_view prefix, depth::Technique& technique) {
    const auto presets = depth::presets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        if (i % 3 != 0) {
            widgets.beside();
        }
        depth::Technique preset = presets[i].technique;
        preset.format = technique.format; // stays, as it does with the keys
        if (widgets.toggle(fmt::format("{}/{}", prefix, presets[i].name), onIf(technique == preset))) {
            technique = preset;
        }
    }
}

void chooseTechnique(const Widgets& widgets, std::string_view prefix, depth::Technique& technique) {
    choosePresets(widgets, prefix, technique);
    depth::Technique wanted = technique;
    choose(widgets, fmt::format("{}/mapping", prefix), depth::kMappings, wanted.mapping);
    const std::size_t split = widgets.combo(fmt::format("{}/split", prefix), nameOf(technique.split),
                                            kSplits.size(), [](std::size_t i) { return kSplits[i]; });
    if (split < kSplits.size()) {
        wanted.split = depth::parseSplit(std::string(kSplits[split]));
    }
    widgets.sentence(explanationOf(technique.split));
    choose(widgets, fmt::format("{}/format", prefix), depth::kDepthFormats, wanted.format);
    technique = wanted;
}

} // namespace

void drawScenePanel(const Widgets& widgets, const RenderResult* result, ViewSettings& settings) {
    widgets.heading("Scene");
    const std::string shown = std::filesystem::path(settings.scene).filename().string();
    const std::span<const std::string_view> scenes = scenes::generatedScenes();
    const std::size_t chosen = widgets.combo(
        "scene", shown, scenes.size(), [&](std::size_t i) { return scenes[i]; }, drawThumbnail);
    if (chosen < scenes.size()) {
        chooseScene(settings, std::string(scenes[chosen]));
    }
    if (result != nullptr && result->scene != nullptr) {
        const scene::OpenedScene& opened = *result->scene;
        bool isBright = settings.colours == scenes::Colours::bright;
        if (scenes::isGreyInThesis(settings.scene) && widgets.checkbox("bright colours", isBright)) {
            chooseColours(settings, isBright ? scenes::Colours::bright : scenes::Colours::thesis);
        }
        widgets.sentence(fmt::format("{}, {}. Drop a .gltf or .glb file to open it.",
                                     counted(opened.setup.scene.objectCount(), "object"),
                                     counted(opened.setup.scene.lights.size(), "light")));
        for (const std::string& line : lightLines(opened.lights)) {
            widgets.sentence(line);
        }
        for (const std::string& note : importerNotes(opened)) {
            widgets.sentence(note);
        }
    }
}

void drawTechniquePanel(const Widgets& widgets, ViewSettings& settings) {
    widgets.heading("Technique");
    bool compares = settings.second.has_value();
    if (widgets.checkbox("compare two", compares)) {
        compareTwo(settings, compares);
    }
    if (!settings.second) {
        chooseTechnique(widgets, "technique", settings.technique);
        return;
    }
    if (ImGui::BeginTabBar("sides")) {
        if (ImGui::BeginTabItem("left of the divider")) {
            chooseTechnique(widgets, "left", settings.technique);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("right")) {
            chooseTechnique(widgets, "right", *settings.second);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
}

void drawViewPanel(const Widgets& widgets, ViewSettings& settings) {
    widgets.heading("View");
    choose(widgets, "view", kViewKinds, settings.view);
}

void drawRenderingPanel(const Widgets& widgets, ViewSettings& settings) {
    widgets.heading("Rendering");
    render::RenderOptions& drawing = settings.drawing;
    render::TargetsKind targets = drawing.targets.kind;
    choose(widgets, "targets", render::kTargetsKinds, targets);
    if (targets != drawing.targets.kind) {
        drawing.targets = targets;
    }
    if (drawing.targets.kind == render::TargetsKind::pool) {
        int layers = static_cast<int>(drawing.targets.layers);
        if (widgets.count("layers", layers, render::kMinPoolLayers, render::kMaxPoolLayers)) {
            drawing.targets = render::TargetsChoice::pool(static_cast<std::uint32_t>(layers));
        }
    }
    int threads = static_cast<int>(drawing.threads);
    if (widgets.count("threads", threads, 1, kMaxThreads)) {
        drawing.threads = static_cast<std::size_t>(std::clamp(threads, 1, kMaxThreads));
    }
    widgets.sentence(explainThreads());
    choose(widgets, "submission", render::kSubmissions, drawing.submission);
    choose(widgets, "batching", render::kBatchings, drawing.batching);
    choose(widgets, "snapping", render::kSnappings, drawing.snapping);
}

} // namespace cdr::viewer
