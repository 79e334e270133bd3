#include "help_texts.h"

#include <cdr/base/enum_names.h>
#include <cdr/depth/technique.h>
#include <cdr/render/shadows/shadows.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::options {

std::string sceneHelp() {
    return fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", "));
}

std::string techniqueHelp() {
    std::string names;
    for (const depth::NamedTechnique& preset : depth::presets()) {
        names += preset.name + ", ";
    }
    return names + "or MAPPING/SPLIT, as --depth and --split of render take them";
}

std::string mappingHelp() {
    return "How distance becomes depth: " + base::listNames(depth::kMappings);
}

std::string shadowTexelsHelp() {
    return fmt::format("Largest side of a shadow map in texels, {} to {}", render::kMinShadowTexels,
                       render::kMaxShadowTexels);
}

} // namespace cdr::options
