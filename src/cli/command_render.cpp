#include "certificate_file.h"
#include "command.h"
#include "commands.h"
#include "frame_division.h"
#include "frame_output.h"
#include "sequence_name.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/render/part_scene.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/lod/levels.h>
#include <experiments/camera_options.h>
#include <experiments/certified_frame.h>
#include <experiments/effect_options.h>
#include <experiments/frame_notes.h>
#include <scenes/colours.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

namespace cdr::cli {

namespace {

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
    experiments::EffectArguments effects;
    std::string detail = "none";
    std::uint32_t snapBits = 0;
    std::size_t threads = 1;
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::string ranks = "frames";
    std::string aov = "color";
    std::string file;
    bool hash = false;
    std::filesystem::path trace;
    std::filesystem::path certify;
    experiments::CameraOptions camera;
    std::string colours = "thesis";
    std::uint64_t seed = scenes::kDefaultSeed;
    scene::GltfChoice choice;
};

depth::NamedTechnique techniqueOf(const RenderArguments& arguments) {
    const bool byParts = !arguments.depth.empty() || !arguments.split.empty();
    if (byParts && !arguments.technique.empty()) {
        throw base::InputError("give either --technique, or --depth and --split");
    }
    depth::NamedTechnique named =
        depth::namedTechnique(arguments.technique.empty() ? "reversed" : arguments.technique);
    if (byParts) {
        named.technique = {.mapping =
                               depth::parseMapping(arguments.depth.empty() ? "standard" : arguments.depth),
                           .split = depth::parseSplit(arguments.split.empty() ? "none" : arguments.split)};
        named.name = partsOf(named.technique);
    }
    if (!arguments.format.empty()) {
        named.technique.format = depth::parseDepthFormat(arguments.format);
    }
    return named;
}

/// What can be wrong with the arguments, before anything is loaded or made.
void checkArguments(const RenderArguments& arguments, const experiments::FrameCameras& cameras,
                    const SequenceName& name, CommandFiles& files) {
    if (cameras.frames > 1 && !arguments.file.empty() && !name.hasNumber()) {
        throw base::InputError(
            fmt::format("{}: several frames need a number in the name, such as %04d", arguments.file));
    }
    if (!arguments.file.empty()) {
        const std::string extension = name.at(cameras.first).extension().string();
        constexpr std::array<std::string_view, 3> kExtensions{".png", ".tga", ".exr"};
        if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
            throw base::InputError(base::unknownName("picture format", extension, kExtensions));
        }
        files.writes("-o", name.at(cameras.first));
    }
    if (!arguments.trace.empty()) {
        files.writes("--trace", arguments.trace);
    }
    if (!arguments.certify.empty()) {
        files.writes("--certify", arguments.certify);
    }
}

nlohmann::ordered_json optionsJson(const RenderArguments& arguments, const depth::Technique& technique) {
    nlohmann::ordered_json options{{"scene", arguments.scene},         {"mapping", nameOf(technique.mapping)},
                                   {"split", nameOf(technique.split)}, {"format", nameOf(technique.format)},
                                   {"width", arguments.width},         {"height", arguments.height},
                                   {"seed", arguments.seed},           {"aov", arguments.aov},
                                   {"snap_bits", arguments.snapBits}};
    const auto add = [&](const char* key, const auto& value) {
        if (value) {
            options[key] = *value;
        }
    };
    add("animation", arguments.choice.animation);
    add("time", arguments.choice.seconds);
    add("fps", arguments.choice.framesPerSecond);
    return options;
}

render::RenderOptions optionsOf(const RenderArguments& arguments, experiments::Aov aov) {
    render::RenderOptions options{.width = arguments.width,
                                  .height = arguments.height,
                                  .technique = techniqueOf(arguments).technique,
                                  .targets = render::parseTargets(arguments.targets),
                                  .threads = arguments.threads,
                                  .submission = render::parseSubmission(arguments.submission),
                                  .batching = render::parseBatching(arguments.batching),
                                  .surface = render::parseSurfacePath(arguments.surface),
                                  .detail = visibility::parseDetail(arguments.detail),
                                  .effects = experiments::effectsOf(arguments.effects),
                                  .focus = experiments::focusOf(arguments.effects),
                                  .translucency = experiments::translucencyOf(arguments.effects)};
    options.snapBits = arguments.snapBits;
    options.occlusionCulling = arguments.occlusionCulling;
    options.translucency.countsFragments = aov == experiments::Aov::coverage;
    return options;
}

/// What a command wants to know of its frames beside what is drawn.
struct WantedOfFrames {
    bool truth = false;
    bool certificate = false;
};

/// Draws frame after frame of a scene, and casts its truth or certifies it where that is wanted.
class FrameMaker {
  public:
    /// @param moving the scene, where it moves; else null.
    FrameMaker(const gpu::Device& device, const scene::Scene& scene, scenes::MovingScene* moving,
               const render::RenderOptions& options, const WantedOfFrames& wanted, host::WorkerPool& workers)
        : m_options(options),
          m_subPixelBits(device.info().subPixelBits),
          m_workers(workers),
          m_moving(moving),
          m_onDevice(moving != nullptr ? render::GpuScene(device, moving->world())
                                       : render::GpuScene(device, scene)),
          m_renderer(moving != nullptr ? render::Renderer(device, m_onDevice, options)
                                       : render::Renderer(device, scene, m_onDevice, options)) {
        if (wanted.truth) {
            m_caster.emplace(scene, workers);
        }
        if (wanted.certificate) {
            m_certifier.emplace(scene, workers);
        }
    }

    /// Goes past a frame that another rank makes.
    void skip(std::uint32_t number, const scene::Camera& camera) {
        show(number);
        m_renderer.skip(camera);
    }

    render::Frame draw(std::uint32_t number, const scene::Camera& camera) {
        show(number);
        if (m_options.trace != nullptr) {
            m_options.trace->beginFrame(fmt::format("frame {}", number));
        }
        return m_renderer.render(camera);
    }

    /// Of the frame that was drawn last.
    FrameOutput finish(std::uint32_t number, render::Frame frame) {
        std::optional<CertifiedOutput> certified;
        if (m_certifier) {
            certified = certify(frame);
        }
        std::optional<measure::TruthImage> truth;
        if (m_caster) {
            truth = m_caster->cast(frame.camera, m_options.width, m_options.height, m_workers);
        }
        return {number, std::move(frame), std::move(truth), std::move(certified)};
    }

  private:
    /// Certifies a frame and repairs it.
    CertifiedOutput certify(render::Frame& frame) {
        const auto begin = std::chrono::steady_clock::now();
        const measure::DrawnFrame drawn = experiments::drawnFrame(frame, m_options, m_subPixelBits);
        CertifiedOutput made{.certificate = m_certifier->certify(drawn, m_workers),
                             .snapPixels = drawn.snapPixels};
        experiments::putRight(frame, made.certificate);
        made.milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        return made;
    }

    void show(std::uint32_t number) {
        if (m_moving == nullptr || !m_moving->show(number, m_workers)) {
            return;
        }
        if (m_caster) {
            m_caster->follow(m_moving->deformedMeshes(), m_workers);
        }
        if (m_certifier) {
            m_certifier->follow(m_moving->deformedMeshes(), m_workers);
        }
    }

    const render::RenderOptions& m_options;
    std::uint32_t m_subPixelBits;
    host::WorkerPool& m_workers;
    scenes::MovingScene* m_moving;
    render::GpuScene m_onDevice;
    render::Renderer m_renderer;
    std::optional<measure::TruthCaster> m_caster;
    std::optional<measure::Certifier> m_certifier;
};

bool hasBlended(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const scene::Material& material) {
        return material.alphaMode == scene::AlphaMode::blend;
    });
}

std::vector<scene::Camera> camerasOf(const scene::CameraPath& path,
                                     const experiments::FrameCameras& cameras) {
    std::vector<scene::Camera> all;
    for (std::uint32_t frame = 0; frame < cameras.frames; ++frame) {
        all.push_back(cameras.at(path, cameras.first + frame));
    }
    return all;
}

/// What differs from what was asked, in words.
std::vector<std::string> notesOn(Command& command, bool isFirst, const FrameOutput& made) {
    const render::Frame& frame = made.frame();
    std::vector<std::string> notes;
    if (const auto& refusal = frame.stats.translucency.refusal) {
        const std::string why =
            experiments::noteOn(*refusal, command.device().info().name, frame.width(), frame.height());
        notes.push_back(fmt::format("frame {} drawn with --translucency weighted: {}", made.number(), why));
    }
    if (isFirst && frame.stats.lostEmission) {
        notes.push_back(fmt::format("drawn otherwise than asked: {}", experiments::noteOnLostEmission()));
    }
    if (isFirst && frame.stats.lostShine) {
        notes.push_back(fmt::format("drawn otherwise than asked: {}", experiments::noteOnLostShine()));
    }
    return notes;
}

/// Where the pictures are, or that there are none.
std::string whatWasWritten(const RenderArguments& arguments, const experiments::FrameCameras& cameras,
                           const SequenceName& name) {
    if (arguments.file.empty()) {
        return fmt::format("{} drawn, no picture written; -o FILE writes {}",
                           cameras.frames == 1 ? "one frame" : fmt::format("{} frames", cameras.frames),
                           cameras.frames == 1 ? "it" : "them");
    }
    const std::string first = name.at(cameras.first).string();
    return cameras.frames == 1
               ? fmt::format("{} written", first)
               : fmt::format("{} to {} written", first, name.at(cameras.first + cameras.frames - 1).string());
}

void runRender(Command& command, RenderArguments& arguments) {
    const experiments::Aov aov = experiments::parseAov(arguments.aov);
    const scenes::Colours colours = scenes::parseColours(arguments.colours);
    const SequenceName name(arguments.file);
    render::RenderOptions options = optionsOf(arguments, aov);
    if (!arguments.camera.path.empty()) {
        command.files().reads(arguments.camera.path);
    }
    const experiments::FrameCameras cameras(arguments.camera);
    checkArguments(arguments, cameras, name, command.files());
    const FrameDivision division = parseFrameDivision(arguments.ranks);
    const ranks::Place& place = command.ranks().place();
    if (division == FrameDivision::cascades) {
        options.part = {.index = place.index, .count = place.count};
    }
    host::WorkerPool workers(arguments.threads);
    std::optional<host::Trace> trace;
    if (!arguments.trace.empty()) {
        if (!command.ranks().isAlone()) {
            throw base::InputError("--trace is of one process: start it without mpirun");
        }
        options.trace = &trace.emplace(options.threads);
    }
    if (!arguments.certify.empty()) {
        experiments::requireCertifiable(options);
    }
    arguments.choice.light = experiments::lightOf(arguments.effects);
    scene::SceneSetup setup = command.openScene(arguments.scene, arguments.seed,
                                                scenes::shownChoice(arguments.scene, arguments.choice));
    scenes::paint(setup.scene, colours);
    cameras.at(setup.path, cameras.first); // an unusable camera ends here, before the device is made
    const bool finishes = division == FrameDivision::frames || command.ranks().isFirst();
    const WantedOfFrames wanted{.truth = aov == experiments::Aov::wrong && finishes,
                                .certificate = !arguments.certify.empty() && finishes};
    if (division == FrameDivision::cascades) {
        requireDivisible(options, hasBlended(setup.scene)); // one process refuses what several do
        if (place.count > 1 && !setup.motion && !wanted.truth && !wanted.certificate) {
            dropOtherParts(setup.scene, options, camerasOf(setup.path, cameras), workers);
        }
    }
    if (options.detail.mode != visibility::DetailMode::none) {
        scene::makeLevels(setup.scene, workers);
    }

    const Console& console = command.console();
    std::optional<scenes::MovingScene> moving;
    if (setup.motion) {
        moving.emplace(std::move(setup.scene), setup.motion);
    }
    FrameMaker maker(command.device(), moving ? moving->world().scene() : setup.scene,
                     moving ? &*moving : nullptr, options, wanted, workers);
    const std::string technique = techniqueOf(arguments).name;
    auto document = command.makeDocument(optionsJson(arguments, options.technique));
    std::optional<CertificateFile> certificates;
    if (!arguments.certify.empty()) {
        certificates.emplace(arguments.certify, command, optionsJson(arguments, options.technique));
    }
    const auto columns = renderColumns({.hash = arguments.hash, .certificate = certificates.has_value()});
    experiments::Table table = experiments::tableOf(columns, std::vector<RenderRow>());
    std::uint32_t next = cameras.first;
    const auto numberOf = [&](std::size_t frame) {
        return cameras.first + static_cast<std::uint32_t>(frame);
    };
    makeFrames(
        command.ranks(), division, cameras.frames,
        {.draw =
             [&](std::size_t frame) {
                 const std::uint32_t number = numberOf(frame);
                 console.progress(frame, cameras.frames, arguments.scene);
                 for (; next < number; ++next) {
                     maker.skip(next, cameras.at(setup.path, next));
                 }
                 render::Frame drawn = maker.draw(next++, cameras.at(setup.path, number));
                 command.opened().requireSilentValidation();
                 return drawn;
             },
         .describe =
             [&](std::size_t frame, render::Frame drawn) {
                 const FrameOutput made = maker.finish(numberOf(frame), std::move(drawn));
                 const std::string hash = arguments.hash || command.output().json ? made.hash(aov) : "";
                 const RenderRow row{made,      options, arguments.scene,
                                     technique, hash,    scene::secondsAt(arguments.choice, made.number())};
                 const auto& certified = made.certified();
                 const bool isWritten =
                     !arguments.file.empty() && !(certified && certified->certificate.isRefused());
                 return experiments::Json{
                     {"notes", notesOn(command, frame == 0, made)},
                     {"row", experiments::jsonOf(columns, row)},
                     {"cells", experiments::cellsOf(columns, row)},
                     {"certificate", certified ? certificateOf(made.number(), made.frame().camera, *certified,
                                                               made.hash(aov))
                                               : experiments::Json()},
                     {"file", isWritten ? experiments::Json::binary(made.encoded(name.at(made.number()), aov))
                                        : experiments::Json()}};
             },
         .take =
             [&](std::size_t frame, experiments::Json made) {
                 for (const experiments::Json& note : made.at("notes")) {
                     console.line(note.get<std::string>());
                 }
                 if (certificates) {
                     certificates->add(std::move(made.at("certificate")));
                 }
                 if (!made.at("file").is_null()) {
                     host::writeFile(name.at(numberOf(frame)), made.at("file").get_binary());
                 }
                 document["results"].push_back(std::move(made.at("row")));
                 table.rows.push_back(made.at("cells").get<std::vector<std::string>>());
             }});
    command.endProgress();
    console.table(table);
    console.line(command.opened().text());
    if (!certificates || !certificates->hasRefused()) {
        console.line(whatWasWritten(arguments, cameras, name));
    }
    if (trace) {
        trace->write(arguments.trace);
    }
    command.writeDocument(document);
    if (certificates && command.ranks().isFirst()) {
        certificates->finish();
    }
}

void addTechniqueOptions(CLI::App& command, RenderArguments& arguments) {
    command.add_option("--technique", arguments.technique,
                       "Preset: standard, cdr, log, logcdr, reversed (default) or anchored");
    command.add_option("--depth", arguments.depth,
                       "Depth mapping, instead of a preset: standard, reversed, log, log-fragment, ...");
    command.add_option(
        "--split", arguments.split,
        "How cascades are cut: none, ratio:R, count:K, at:a,b,..., minimax:K or fitted[:TARGET[px][,max=K]]");
    command.add_option("--format", arguments.format, "Depth buffer: d16, d24 or d32f");
    command
        .add_option("--targets", arguments.targets,
                    "How cascades reach the G-buffer: single, accumulate, pool, pool:LAYERS, layers or "
                    "one-pass")
        ->capture_default_str();
    command
        .add_option("--submission", arguments.submission,
                    "How draws reach the device: secondaries, primaries or gpu-driven")
        ->capture_default_str();
    command
        .add_option("--batching", arguments.batching,
                    "How draws become commands: per-object, push-constants or instanced")
        ->capture_default_str();
    command
        .add_option("--surface", arguments.surface,
                    "What is kept of surfaces until they are shaded: gbuffer or visibility")
        ->capture_default_str();
    command.add_flag("--occlusion-culling", arguments.occlusionCulling,
                     "Leave out what opaque surfaces hide; the picture is the same");
    command
        .add_option("--detail", arguments.detail,
                    "Level of detail by projected error: none, object[:PIXELS] or cascade[:PIXELS]")
        ->capture_default_str();
    command.add_option("--threads", arguments.threads, "Threads that cull, bin and record")
        ->capture_default_str();
}

void addRenderOptions(CLI::App& command, RenderArguments& arguments) {
    command
        .add_option("scene", arguments.scene,
                    fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", ")))
        ->required();
    command.option_defaults()->group("Technique");
    addTechniqueOptions(command, arguments);
    command.option_defaults()->group("Effects");
    experiments::addEffectOptions(command, arguments.effects);
    command.option_defaults()->group("Camera");
    experiments::addFrameOptions(command, arguments.camera);
    experiments::addCameraOptions(command, arguments.camera);
    command.option_defaults()->group("Scene");
    experiments::addSceneChoice(command, arguments.choice);
    experiments::addAnimationChoice(command, arguments.choice);
    addSeed(command, arguments.seed, "Seed of a random scene");
    experiments::addColours(command, arguments.colours);
    command.option_defaults()->group("Ranks");
    command
        .add_option(
            "--ranks", arguments.ranks,
            "What the ranks of an MPI run divide: frames, or the cascades of each frame, which are drawn apart "
            "and laid over each other, the nearest on top. Cascades go without smoothed edges, whole-picture "
            "occlusion, a focus, blended materials and gpu-driven draws")
        ->capture_default_str();
    command.option_defaults()->group("Output");
    addSize(command, arguments.width, arguments.height);
    addSnapBits(command, arguments.snapBits);
    command
        .add_option("--aov", arguments.aov, "Output: color, id, distance, normal, cascade, wrong or coverage")
        ->capture_default_str();
    command.add_option("-o,--output", arguments.file,
                       "Picture to write: .png, .tga or .exr; %04d stands for the frame");
    command.add_option(
        "--certify", arguments.certify,
        "Show of each pixel that it is right, cast what is in doubt, put right what is wrong; the certificate to "
        "write, .json. Status 3 where the device kept not to its limits");
    command.add_option(
        "--trace", arguments.trace,
        "Write workers, cascades and execute as a trace for ui.perfetto.dev or chrome://tracing");
    command.add_flag("--hash", arguments.hash, "Print a SHA-256 of each output's values");
}

} // namespace

void addRender(CLI::App& program, const GlobalOptions& global) {
    addCommand<RenderArguments>(program, global, "render", "Render a scene into pictures", addRenderOptions,
                                runRender, RankUse::all);
}

} // namespace cdr::cli
