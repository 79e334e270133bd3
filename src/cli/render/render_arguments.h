#pragma once

#include <CLI/CLI.hpp>
#include <cdr/depth/technique.h>
#include <cdr/render/render_options.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/open_scene.h>

#include <nlohmann/json.hpp>
#include <options/camera_options.h>
#include <options/effect_options.h>
#include <options/views/views_plan.h>
#include <output/aov.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cdr::cli {

/// What `render` was given.
struct RenderArguments {
    std::string scene;
    std::string technique;
    std::string depth;
    std::string split;
    std::string format;
    std::string targets = "single";
    std::string submission = "secondaries";
    std::string batching = "instanced";
    std::string surface = "gbuffer";
    bool occlusionCulling = false;
    options::EffectArguments effects;
    std::string detail = "none";
    std::uint32_t snapBits = 0;
    render::Snapping snapping = render::Snapping::byDevice;
    std::size_t threads = 1;
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::string ranks = "frames";
    std::string aov = "color";
    std::string file;
    bool hash = false;
    std::filesystem::path trace;
    std::filesystem::path certify;
    std::filesystem::path state;
    options::CameraOptions camera;
    options::ViewsArguments views;
    std::string colours = "thesis";
    std::vector<std::string> layers; ///< for scenes::parseLayer()
    std::uint64_t seed = scenes::kDefaultSeed;
    scene::GltfChoice choice;
};

/// The technique of --technique, or of --depth and --split. base::InputError where both are given or a name is unknown.
depth::NamedTechnique techniqueOf(const RenderArguments& arguments);

/// base::InputError where a name is unknown.
render::RenderOptions optionsOf(const RenderArguments& arguments, output::Aov aov);

/// "options" of the command's JSON.
nlohmann::ordered_json optionsJson(const RenderArguments& arguments, const depth::Technique& technique);

void addRenderOptions(CLI::App& command, RenderArguments& arguments);

} // namespace cdr::cli
