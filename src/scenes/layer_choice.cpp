#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <scenes/layer_choice.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string_view>

namespace cdr::scenes {

namespace {

constexpr std::size_t kMaxShown = 60; ///< letters of what was given, in messages
constexpr char kIndexSign = '#';

/// Of "#N". base::InputError unless the scene has such a material.
std::size_t indexOf(const scene::Scene& scene, std::string_view material) {
    const std::string_view digits = material.substr(1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc() || end != digits.data() + digits.size() || index >= scene.materials.size()) {
        throw base::inputError("no material '{}': the scene has {}, counted from #0",
                               material.substr(0, kMaxShown), scene.materials.size());
    }
    return index;
}

std::ptrdiff_t countOf(const scene::Scene& scene, std::string_view name) {
    return std::count_if(scene.materials.begin(), scene.materials.end(),
                         [name](const scene::Material& material) { return material.name == name; });
}

base::InputError unknownMaterial(const scene::Scene& scene, std::string_view name) {
    constexpr std::size_t kMaxListed = 30;
    std::vector<std::string_view> known;
    for (const scene::Material& material : scene.materials) {
        if (known.size() < kMaxListed && !material.name.empty()) {
            known.push_back(material.name);
        }
    }
    return base::InputError(base::unknownName("material", name, known));
}

} // namespace

std::string materialName(const scene::Scene& scene, std::uint32_t material) {
    const std::string& name = scene.materials.at(material).name;
    const bool isPlain = !name.empty() && name.front() != kIndexSign && countOf(scene, name) == 1;
    return isPlain ? name : fmt::format("{}{}", kIndexSign, material);
}

std::vector<float> layersOf(const scene::Scene& scene, std::span<const LayerChoice> choices) {
    std::vector<float> layers;
    std::ranges::transform(scene.materials, std::back_inserter(layers), &scene::Material::layer);
    for (const LayerChoice& choice : choices) {
        if (choice.material.starts_with(kIndexSign)) {
            layers[indexOf(scene, choice.material)] = choice.layer;
            continue;
        }
        if (countOf(scene, choice.material) == 0) {
            throw unknownMaterial(scene, choice.material);
        }
        for (std::size_t i = 0; i < layers.size(); ++i) {
            layers[i] = scene.materials[i].name == choice.material ? choice.layer : layers[i];
        }
    }
    return layers;
}

void setLayers(scene::Scene& scene, std::span<const LayerChoice> choices) {
    const std::vector<float> layers = layersOf(scene, choices);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        scene.materials[i].layer = layers[i];
    }
}

} // namespace cdr::scenes
