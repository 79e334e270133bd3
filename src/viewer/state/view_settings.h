#pragma once

#include "camera/camera_input.h"

#include <cdr/render/renderer.h>
#include <scenes/colours.h>
#include <scenes/deform.h>
#include <scenes/layer_choice.h>
#include <scenes/open_scene.h>

#include <options/views/views_plan.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::viewer {

/// What of a frame is shown.
enum class ViewKind : std::uint8_t { shaded, cascades, distance, ids, wrong, flips };
inline constexpr std::array kViewKinds{ViewKind::shaded, ViewKind::cascades, ViewKind::distance,
                                       ViewKind::ids,    ViewKind::wrong,    ViewKind::flips};

/// "shaded", "cascades", "distance", "ids", "wrong" or "flips".
std::string_view nameOf(ViewKind view);

/// Whether a view compares with the anchored answer, which must then be rendered too.
bool needsReference(ViewKind view);
/// That answer's technique: anchored with the finest target there is sense in.
depth::Technique referenceTechnique();

/// Everything that a person chooses but the camera.
struct ViewSettings {
    std::string scene = "rotation"; ///< a name or file for scenes::openScene()
    std::uint64_t openings = 0;     ///< how often a file was asked for: it may have changed since
    std::uint64_t seed = scenes::kDefaultSeed;
    scenes::Colours colours = scenes::Colours::thesis; ///< of a generated scene
    scene::GltfChoice choice{};                        ///< of a glTF file
    std::vector<scenes::LayerChoice> layers{};         ///< of materials, instead of the scene's own
    depth::Technique technique = depth::parseTechnique("anchored"); ///< the left one of a split screen
    std::optional<depth::Technique> second{}; ///< right of the divider; empty for one picture
    double divider = 0.5;                     ///< share of the width that the left picture has, 0 to 1
    render::RenderOptions drawing{};          ///< but for sizes and techniques; some of it may be unused
    ViewKind view = ViewKind::shaded;
    options::ViewsArguments views{};     ///< one eye, or two
    options::ViewsArguments givenEyes{}; ///< the two of the command line, which come back after one; or none
    /// Who bends skins and morph targets; nothing: the device, if it is a graphics card that can.
    std::optional<scenes::Deform> deform{};

    bool operator==(const ViewSettings&) const = default;
};

/// Another scene, or the same as it is by itself: what was chosen of its contents goes. What bounds textures and
/// points stays, and so do a lamp or a sky from file to file. A file is read again, even if it is the one that is open.
void chooseScene(ViewSettings& settings, std::string nameOrPath);

/// Other colours. They come with materials of their own, so layers that were given to materials go.
void chooseColours(ViewSettings& settings, scenes::Colours colours);

/// The layer that the settings give a material; empty where it has the scene's own.
std::optional<float> chosenLayer(const ViewSettings& settings, const scene::Scene& scene,
                                 std::uint32_t material);
/// Gives a material alone a layer, in scene units.
void chooseLayer(ViewSettings& settings, const scene::Scene& scene, std::uint32_t material, float layer);
/// Gives a material the scene's own layer again, and with it those of its name that were given one as one.
void clearLayer(ViewSettings& settings, const scene::Scene& scene, std::uint32_t material);

/// What is wanted once a request failed: what was last shown, unless something else was chosen since. The divider stays.
ViewSettings settingsAfterFailure(const ViewSettings& now, const ViewSettings& failed,
                                  const ViewSettings& shown);

/// Splits the screen, with `anchored` in the format of the left side at the right, or joins it.
void compareTwo(ViewSettings& settings, bool compares);

/// Whether what is drawn depends on the frames before, as fitted splits do.
bool remembersFrames(const ViewSettings& settings);

/// Whether the shadows that are chosen are drawn, beside what else is chosen.
bool castsShadows(const render::RenderOptions& options);

/// How one side, 0 left or 1 right, is rendered. With two eyes beside each other, each has half of the width. Occlusion
/// per cascade is for layered targets, so with others it is worked out over the whole picture. A focus is for `layers`
/// alone, so with others there is none. There are no shadows with a focus, nor where levels of detail cast none.
render::RenderOptions renderOptions(const ViewSettings& settings, std::size_t side,
                                    const PictureExtent& extent);

/// Keys 1 to 6: the presets of depth::presets(), worst first.
inline constexpr std::size_t kPresetKeys = 6;
/// @param key 1 to kPresetKeys.
depth::Technique presetOfKey(std::size_t key);
/// The settings with a preset on one side (0 left, 1 right), its depth format kept.
ViewSettings withPreset(ViewSettings settings, std::size_t side, std::size_t key);

} // namespace cdr::viewer
