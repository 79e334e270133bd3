#include <cdr/base/enum_names.h>
#include <scenes/colours.h>
#include <scenes/open_scene.h>
#include <scenes/scene_builder.h>

namespace cdr::scenes {

namespace {

constexpr base::EnumNames<Colours, kColours.size()> kColourNames{"colours", {"thesis", "bright"}};

/// Linear. None is red, which marks what is wrong.
constexpr std::array<std::array<float, 3>, 7> kPalette{{{0.05f, 0.34f, 0.38f},
                                                        {0.80f, 0.40f, 0.06f},
                                                        {0.07f, 0.17f, 0.50f},
                                                        {0.76f, 0.64f, 0.36f},
                                                        {0.18f, 0.42f, 0.14f},
                                                        {0.34f, 0.16f, 0.48f},
                                                        {0.62f, 0.68f, 0.72f}}};

/// The material that is in the thesis' grey in scenes that can be painted.
constexpr std::uint32_t kGrey = 0;

/// Objects in a row share a colour where there are many, since a run of one material is one draw.
constexpr std::uint32_t kMaxRuns = 4096;

void addPalette(scene::Scene& scene) {
    const auto first = static_cast<std::uint32_t>(scene.materials.size());
    for (const auto& [red, green, blue] : kPalette) {
        scene.materials.push_back({.name = "colour", .baseColorFactor = glm::vec4(red, green, blue, 1.0f)});
    }
    const std::uint32_t run = 1 + scene.objectCount() / kMaxRuns;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        std::uint32_t& material = scene.instances.material[i];
        if (material == kGrey) {
            material = first + static_cast<std::uint32_t>(scene.instances.object[i] / run % kPalette.size());
        }
    }
}

} // namespace

std::string_view nameOf(Colours colours) {
    return kColourNames.nameOf(colours);
}

Colours parseColours(std::string_view name) {
    return kColourNames.parse(name);
}

void paint(scene::Scene& scene, std::string_view name, Colours colours) {
    if (colours == Colours::thesis || !isGreyInThesis(name)) {
        return;
    }
    addPalette(scene);
    constexpr double kFar = 1e12;
    for (scene::PointLight& own : scene.lights) {
        own.color *= 0.3f;
    }
    scene::PointLight sun = farLight({0.45, 0.75, 0.60}, kFar);
    sun.color = {0.95f, 0.90f, 0.80f};
    scene::PointLight sky = farLight({-0.6, 0.25, -0.75}, kFar);
    sky.color = {0.30f, 0.38f, 0.50f};
    scene.lights.insert(scene.lights.end(), {sun, sky});
    scene.ambient = {0.30f, 0.34f, 0.42f};
    scene.background = {0.010f, 0.016f, 0.032f};
}

} // namespace cdr::scenes
