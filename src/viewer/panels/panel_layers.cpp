#include "panels.h"

#include <viewer/state/plain_words.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace cdr::viewer {

namespace {

constexpr std::size_t kMaxMaterials = 8;

void drawLayer(const Widgets& widgets, const scene::Scene& scene, std::uint32_t material,
               ViewSettings& settings) {
    const scene::Material& own = scene.materials[material];
    widgets.value("material", own.name.empty() ? scenes::materialName(scene, material) : own.name);
    float layer = chosenLayer(settings, scene, material).value_or(own.layer);
    const bool isTyped = widgets.number(fmt::format("{}/layer", material), layer);
    if (isTyped && (layer == 0.0f || std::isnormal(layer))) { // as --layer takes it
        chooseLayer(settings, scene, material, layer);
    }
    if (own.alphaMode == scene::AlphaMode::blend) {
        widgets.sentence("It blends: it is offset before opaque faces, but does not know their layers.");
    }
}

} // namespace

void drawLayersPanel(const Widgets& widgets, const PictureModel& picture, ViewSettings& settings) {
    const bool isPicked = picture.measuring.first().has_value() && picture.shown != nullptr;
    if (!isPicked || picture.shown->sceneName != settings.scene ||
        picture.shown->settings.colours != settings.colours) {
        return; // or the layers of other materials would be chosen
    }
    widgets.heading("Layer");
    const scene::Scene& scene = picture.shown->scene->setup.scene;
    const std::span<const std::uint32_t> materials(picture.pickedMaterials);
    const auto listed = materials.first(std::min(materials.size(), kMaxMaterials));
    for (const std::uint32_t material : listed) {
        drawLayer(widgets, scene, material, settings);
    }
    if (listed.size() < materials.size()) {
        widgets.sentence("and " + counted(materials.size() - listed.size(), "more material"));
    }
    const bool isChosen = std::ranges::any_of(
        listed, [&](std::uint32_t material) { return chosenLayer(settings, scene, material).has_value(); });
    if (isChosen && widgets.button("the scene's own")) {
        for (const std::uint32_t material : listed) {
            clearLayer(settings, scene, material);
        }
    }
    widgets.sentence(
        "Of two faces at one place, the one in the higher layer is seen. A layer moves faces "
        "towards the camera, in scene units, for this decision alone. All objects of the material "
        "have it.");
}

} // namespace cdr::viewer
