#include "command_line.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <viewer/state/camera/stereo_view.h>

#include <fmt/format.h>
#include <options/layer_text.h>
#include <output/aov.h>
#include <program/child_process.h>

#include <algorithm>
#include <vector>

namespace cdr::viewer {

namespace {

using output::Aov;

Aov aovOf(ViewKind view) {
    switch (view) {
    case ViewKind::cascades:
        return Aov::cascade;
    case ViewKind::distance:
        return Aov::distance;
    case ViewKind::ids:
        return Aov::id;
    case ViewKind::wrong:
        return Aov::wrong;
    case ViewKind::shaded:
    case ViewKind::flips:
        break;
    }
    return Aov::color;
}

/// Words of a command line, quoted one by one.
class Words {
  public:
    void add(std::string_view word) {
        if (!m_line.empty()) {
            m_line += ' ';
        }
        m_line += program::shellQuoted(word);
    }
    /// An option and its value in one word, since a value may begin with a minus.
    void add(std::string_view option, std::string_view value) { add(fmt::format("{}={}", option, value)); }
    void addUnless(bool isDefault, std::string_view option, std::string_view value) {
        if (!isDefault) {
            add(option, value);
        }
    }
    const std::string& line() const { return m_line; }

  private:
    std::string m_line;
};

void addFinish(Words& words, const render::RenderOptions& options) {
    const render::RenderOptions defaults;
    words.addUnless(options.detail.mode == defaults.detail.mode, "--detail",
                    visibility::nameOf(options.detail));
    words.addUnless(options.translucency.method == defaults.translucency.method, "--translucency",
                    render::nameOf(options.translucency.method));
    // Where they say nothing, cdr render refuses them.
    const bool isSorted = options.translucency.method == render::Translucency::sorted;
    words.addUnless(!isSorted || options.translucency.maxBytes == defaults.translucency.maxBytes,
                    "--translucency-memory", fmt::format("{}", options.translucency.maxBytes >> 20u));
    words.addUnless(!options.shadows.isOn(), "--shadows", render::nameOf(options.shadows.method));
    words.addUnless(!options.shadows.isOn() || options.shadows.maxTexels == defaults.shadows.maxTexels,
                    "--shadow-texels", fmt::format("{}", options.shadows.maxTexels));
    const render::Effects& effects = options.effects;
    words.addUnless(effects.antialias == defaults.effects.antialias, "--antialias",
                    render::nameOf(effects.antialias));
    words.addUnless(
        effects.occlusion.radius == 0.0, "--occlusion",
        fmt::format("{}{}", effects.occlusion.radius, effects.occlusion.perLayer ? ":layers" : ""));
    words.addUnless(!options.focus.isOn(), "--focus",
                    fmt::format("{}:{}{}", options.focus.distance, options.focus.aperture,
                                options.focus.blend ? ":blend" : ""));
    words.addUnless(effects.finish.toneMap == defaults.effects.finish.toneMap, "--tone-map",
                    render::nameOf(effects.finish.toneMap));
    words.addUnless(effects.finish.exposure == 0.0, "--exposure", fmt::format("{}", effects.finish.exposure));
    const render::Fog& fog = effects.fog;
    const std::string color = fog.color == defaults.effects.fog.color
                                  ? ""
                                  : fmt::format(",{},{},{}", fog.color.r, fog.color.g, fog.color.b);
    words.addUnless(fog.visibility == 0.0, "--fog", fmt::format("{}{}", fog.visibility, color));
}

void addEyes(Words& words, const ViewSettings& settings) {
    const std::optional<options::StereoPicture> picture = stereoPictureOf(settings);
    if (!picture) {
        return;
    }
    const options::ViewsArguments& views = settings.views;
    words.add("--stereo", nameOf(*views.stereo));
    words.add("--eye-distance", fmt::format("{}", views.eyeDistance.value_or(0.0)));
    words.addUnless(!views.converge, "--converge", fmt::format("{}", views.converge.value_or(0.0)));
    const bool isOfColours = aovOf(settings.view) == Aov::color; // other outputs have no anaglyph
    words.addUnless(*picture == options::StereoPicture::sideBySide || !isOfColours, "--stereo-picture",
                    nameOf(*picture));
}

void addDrawing(Words& words, const render::RenderOptions& options) {
    const depth::Technique& technique = options.technique;
    if (const std::string name = depth::nameOf(technique); name != depth::partsOf(technique)) {
        words.add("--technique", name);
    } else {
        words.add("--depth", depth::nameOf(technique.mapping));
        words.add("--split", depth::nameOf(technique.split));
    }
    words.addUnless(technique.format == depth::DepthFormat::d32f, "--format",
                    depth::nameOf(technique.format));
    const render::RenderOptions defaults;
    words.addUnless(options.targets == defaults.targets, "--targets", render::nameOf(options.targets));
    words.addUnless(options.submission == defaults.submission, "--submission",
                    render::nameOf(options.submission));
    words.addUnless(options.batching == defaults.batching, "--batching", render::nameOf(options.batching));
    words.addUnless(options.snapping == defaults.snapping, "--snapping", render::nameOf(options.snapping));
    addFinish(words, options);
    words.addUnless(options.threads == defaults.threads, "--threads", fmt::format("{}", options.threads));
}

bool isSamePose(const scene::Camera& a, const scene::Camera& b) {
    return a.position == b.position && a.right == b.right && a.up == b.up && a.back == b.back;
}

void addCamera(Words& words, const ReproducedView& view) {
    const scene::Camera& camera = view.camera;
    const scene::Camera& own = view.sceneCamera;
    if (!isSamePose(camera, own)) {
        const scene::Camera said = scene::canonical(camera);
        words.add("--eye", exactText(said.position));
        words.add("--direction", exactText(-said.back));
        words.addUnless(scene::isLevel(said), "--up", exactText(said.up));
    }
    words.addUnless(camera.fovY == own.fovY, "--fov", fmt::format("{}", scene::degreesOf(camera.fovY)));
    words.addUnless(camera.lensShift == own.lensShift, "--lens-shift",
                    fmt::format("{},{}", camera.lensShift.x, camera.lensShift.y));
    words.addUnless(camera.nearView == own.nearView, "--near", fmt::format("{}", camera.nearView));
    words.addUnless(camera.farView == own.farView, "--far", fmt::format("{}", camera.farView));
}

} // namespace

std::string renderCommand(const ReproducedView& view, std::string_view output) {
    const ViewSettings& settings = view.settings;
    Words words;
    words.add("cdr");
    words.add("render");
    // A file whose name begins with a minus would be an option.
    words.add(settings.scene.starts_with('-') ? fmt::format("./{}", settings.scene) : settings.scene);
    addDrawing(words, renderOptions(settings, view.side, view.extent));
    words.addUnless(view.frame == 0, "--frame", fmt::format("{}", view.frame));
    addCamera(words, view);
    addEyes(words, settings);
    const bool isGrey = settings.colours == scenes::Colours::thesis || scene::isGltfPath(settings.scene);
    words.addUnless(isGrey, "--colours", nameOf(settings.colours));
    for (const scenes::LayerChoice& layer : settings.layers) {
        words.add("--layer", options::textOf(layer));
    }
    const auto addGiven = [&words](std::string_view option, const auto& given) {
        if (given) {
            words.add(option, fmt::format("{}", *given));
        }
    };
    addGiven("--gltf-scene", settings.choice.scene);
    addGiven("--camera", settings.choice.camera);
    if (settings.choice.light) {
        words.add("--light", nameOf(*settings.choice.light));
    }
    addGiven("--animation", settings.choice.animation);
    addGiven("--time", settings.choice.seconds);
    addGiven("--fps", settings.choice.framesPerSecond);
    if (settings.deform && scene::isGltfPath(settings.scene)) {
        words.add("--deform", nameOf(*settings.deform));
    }
    addGiven("--texture-memory", settings.choice.textureMiB);
    addGiven("--points", settings.choice.pointRadius);
    words.addUnless(settings.seed == scenes::kDefaultSeed, "--seed", fmt::format("{}", settings.seed));
    words.add("--size", fmt::format("{}x{}", view.extent.width, view.extent.height));
    const Aov aov = aovOf(settings.view);
    words.addUnless(aov == Aov::color, "--aov", nameOf(aov));
    words.addUnless(view.device.empty(), "--device", view.device);
    words.add("--output", output);
    return words.line();
}

ViewKind viewOfAov(std::string_view aov) {
    std::vector<std::string_view> known;
    for (const ViewKind view : kViewKinds) {
        const std::string_view name = nameOf(aovOf(view));
        if (name == aov) {
            return view; // of two with one name the first, which is shaded
        }
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            known.push_back(name);
        }
    }
    throw base::InputError(base::unknownName("output", aov, known));
}

std::string exactText(const glm::dvec3& point) {
    return fmt::format("{},{},{}", point.x, point.y, point.z);
}

} // namespace cdr::viewer
