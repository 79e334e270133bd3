#include "view_settings.h"

#include <cdr/base/enum_names.h>
#include <viewer/state/camera/stereo_view.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr base::EnumNames<ViewKind, kViewKinds.size()> kNames{
    "view", {"shaded", "cascades", "distance", "ids", "wrong", "flips"}};

/// Whether a choice means a material.
bool isOf(const scenes::LayerChoice& choice, const scene::Scene& scene, std::uint32_t material) {
    return choice.material == fmt::format("#{}", material) ||
           (!choice.material.starts_with('#') && choice.material == scene.materials[material].name);
}

void leaveOutUnused(render::RenderOptions& options) {
    render::Occlusion& occlusion = options.effects.occlusion;
    occlusion.perLayer = occlusion.perLayer && hasLayers(options.targets.kind);
    if (options.targets.kind != render::TargetsKind::layers) {
        options.focus = {};
    }
    if (!castsShadows(options)) {
        options.shadows = {};
    }
}

} // namespace

std::string_view nameOf(ViewKind view) {
    return kNames.nameOf(view);
}

bool needsReference(ViewKind view) {
    return view == ViewKind::wrong || view == ViewKind::flips;
}

depth::Technique referenceTechnique() {
    // A hundred times finer than the preset's, which a crowded scene may relax again.
    return {.mapping = depth::Mapping::anchored, .split = depth::SplitFitted{.target = 1e-5}};
}

void chooseScene(ViewSettings& settings, std::string nameOrPath) {
    settings.openings += scene::isGltfPath(nameOrPath) ? 1 : 0;
    settings.scene = std::move(nameOrPath);
    scene::GltfChoice kept;
    kept.textureMiB = settings.choice.textureMiB;
    kept.pointRadius = settings.choice.pointRadius;
    if (scene::isGltfPath(settings.scene) && settings.choice.light != scene::ModelLight::file) {
        kept.light = settings.choice.light;
    }
    settings.choice = kept;
    settings.layers.clear();
}

void chooseColours(ViewSettings& settings, scenes::Colours colours) {
    settings.colours = colours;
    settings.layers.clear();
}

std::optional<float> chosenLayer(const ViewSettings& settings, const scene::Scene& scene,
                                 std::uint32_t material) {
    const auto found =
        std::find_if(settings.layers.rbegin(), settings.layers.rend(),
                     [&](const scenes::LayerChoice& choice) { return isOf(choice, scene, material); });
    return found == settings.layers.rend() ? std::nullopt : std::optional(found->layer);
}

void chooseLayer(ViewSettings& settings, const scene::Scene& scene, std::uint32_t material, float layer) {
    const std::string name = scenes::materialName(scene, material);
    const std::string byIndex = fmt::format("#{}", material);
    std::erase_if(settings.layers, [&](const scenes::LayerChoice& choice) {
        return choice.material == name || choice.material == byIndex;
    });
    settings.layers.push_back({.material = name, .layer = layer});
}

void clearLayer(ViewSettings& settings, const scene::Scene& scene, std::uint32_t material) {
    std::erase_if(settings.layers,
                  [&](const scenes::LayerChoice& choice) { return isOf(choice, scene, material); });
}

bool remembersFrames(const ViewSettings& settings) {
    const auto isFitted = [](const depth::Technique& technique) {
        return std::holds_alternative<depth::SplitFitted>(technique.split);
    };
    return isFitted(settings.technique) || (settings.second && isFitted(*settings.second));
}

bool castsShadows(const render::RenderOptions& options) {
    const bool isFocused = options.targets.kind == render::TargetsKind::layers && options.focus.isOn();
    return options.shadows.isOn() && !isFocused && render::castsShadows(options.detail.mode);
}

render::RenderOptions renderOptions(const ViewSettings& settings, std::size_t side,
                                    const PictureExtent& extent) {
    const PictureExtent eye = extentOfEye(settings, extent);
    render::RenderOptions options = settings.drawing;
    options.width = eye.width;
    options.height = eye.height;
    options.technique = side == 1 && settings.second ? *settings.second : settings.technique;
    leaveOutUnused(options);
    return options;
}

ViewSettings settingsAfterFailure(const ViewSettings& now, const ViewSettings& failed,
                                  const ViewSettings& shown) {
    ViewSettings asked = failed;
    asked.divider = now.divider;
    ViewSettings next = now == asked ? shown : now;
    next.divider = now.divider;
    return next;
}

void compareTwo(ViewSettings& settings, bool compares) {
    settings.second.reset();
    if (compares) {
        settings.second = depth::parseTechnique("anchored");
        settings.second->format = settings.technique.format;
    }
}

depth::Technique presetOfKey(std::size_t key) {
    return depth::presets()[std::clamp<std::size_t>(key, 1, kPresetKeys) - 1].technique;
}

ViewSettings withPreset(ViewSettings settings, std::size_t side, std::size_t key) {
    depth::Technique& changed = side == 1 && settings.second ? *settings.second : settings.technique;
    const depth::DepthFormat format = changed.format;
    changed = presetOfKey(key);
    changed.format = format;
    return settings;
}

} // namespace cdr::viewer
