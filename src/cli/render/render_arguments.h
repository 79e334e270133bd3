#pragma once

#include <CLI/CLI.hpp>
#include <cdr/depth/technique.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/open_scene.h>

#include <nlohmann/json.hpp>
#include <options/camera_options.h>
#include <options/deform_choice.h>
#include <options/drawing_options.h>
#include <options/scene_options.h>
#include <options/views/views_plan.h>
#include <output/aov.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cdr::cli {

/// What of a command's frames its ranks divide among them.
enum class FrameDivision : std::uint8_t {
    frames,  ///< each frame is one rank's
    cascades ///< each rank draws neighbouring cascades of every frame, which are laid over each other
};

/// What `render` was given.
struct RenderArguments {
    std::string scene;
    std::optional<depth::NamedTechnique> technique; ///< a preset, or mapping/split
    options::TechniqueParts parts;                  ///< instead of it
    std::optional<depth::DepthFormat> format;
    render::RenderOptions drawing; ///< but for the technique, for which there is optionsOf()
    FrameDivision ranks = FrameDivision::frames;
    output::Aov aov = output::Aov::color;
    std::string file;
    bool hash = false;
    std::filesystem::path trace;
    std::filesystem::path certify;
    std::filesystem::path state;
    options::CameraOptions camera;
    options::ViewsArguments views;
    std::optional<scenes::Colours> colours = scenes::Colours::thesis;
    options::LayerArguments layers;
    std::uint64_t seed = scenes::kDefaultSeed;
    scene::GltfChoice choice;
    std::optional<scenes::Deform> deform; ///< told; once frames are drawn, who deforms what does
};

/// The technique of --technique, or of --depth and --split. base::InputError where both are given.
depth::NamedTechnique techniqueOf(const RenderArguments& arguments);

/// What a renderer is made with. base::InputError as techniqueOf().
render::RenderOptions optionsOf(const RenderArguments& arguments);

/// "options" of the command's JSON.
nlohmann::ordered_json optionsJson(const RenderArguments& arguments, const depth::Technique& technique);

void addRenderOptions(CLI::App& command, RenderArguments& arguments);

} // namespace cdr::cli
