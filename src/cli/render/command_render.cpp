#include "../command.h"
#include "../commands.h"
#include "frame_maker.h"
#include "render_arguments.h"
#include "render_results.h"
#include "sequence_name.h"

#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <cdr/platform/file.h>
#include <cdr/render/part_scene.h>
#include <scenes/colours.h>
#include <scenes/layer_choice.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <output/certified_frame.h>
#include <runs/part_frames.h>
#include <runs/units.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace cdr::cli {

namespace {

/// What the arguments mean. Nothing is loaded or made yet.
struct RenderPlan {
    SequenceName name;
    options::FrameCameras cameras;
    render::RenderOptions options;
    options::ViewsPlan views;
};

/// Of the files that are read and written.
void checkFiles(const RenderArguments& arguments, const RenderPlan& plan, CommandFiles& files) {
    if (plan.cameras.frames > 1 && !arguments.file.empty() && !plan.name.hasNumber()) {
        throw base::inputError("{}: several frames need a number in the name, such as %04d", arguments.file);
    }
    if (!arguments.file.empty()) {
        const std::string extension = platform::lowerExtension(plan.name.at(plan.cameras.first));
        constexpr std::array<std::string_view, 3> kExtensions{".png", ".tga", ".exr"};
        if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
            throw base::InputError(base::unknownName("picture format", extension, kExtensions));
        }
        files.writes("-o", plan.name.at(plan.cameras.first));
        const std::size_t first = plan.cameras.first; // the end may be 2^32
        files.writesSequence(
            "-o", first + 1, first + plan.cameras.frames,
            [name = plan.name](std::size_t frame) { return name.at(static_cast<unsigned>(frame)); });
    }
    files.mayWrite("--trace", arguments.trace);
    if (!arguments.certify.empty() && platform::lowerExtension(arguments.certify) != ".json") {
        throw base::inputError("--certify: {} does not end in .json", arguments.certify.string());
    }
    files.mayWrite("--certify", arguments.certify);
}

/// base::InputError for several views with options that take one view.
void requireOneView(const RenderArguments& arguments, const RenderPlan& plan) {
    if (plan.views.kind() == options::ViewsKind::one) {
        return;
    }
    if (plan.views.kind() == options::ViewsKind::six &&
        (arguments.camera.fovDegrees || arguments.camera.lensShift)) {
        throw base::InputError("--views six has views of 90 degrees: leave out --fov and --lens-shift");
    }
    if (!arguments.certify.empty()) {
        throw base::InputError("--certify works with one view: leave out --stereo and --views");
    }
    if (arguments.ranks == FrameDivision::cascades) {
        throw base::InputError("--ranks cascades works with one view: leave out --stereo and --views");
    }
    if (plan.views.isAnaglyph() && arguments.aov != output::Aov::color) {
        throw base::InputError(
            "--stereo-picture anaglyph shows colors: leave out --aov, or take side-by-side");
    }
}

/// base::InputError for --deform where nothing can bend.
void requireBending(const RenderArguments& arguments) {
    if (arguments.deform && !scene::isGltfPath(arguments.scene)) {
        throw base::inputError("--deform is for glTF files: {} has no skins and no morph targets",
                               arguments.scene.substr(0, 200));
    }
}

RenderPlan planOf(Command& command, const RenderArguments& arguments) {
    const SequenceName name(arguments.file);
    render::RenderOptions options = optionsOf(arguments);
    if (!arguments.camera.path.empty()) {
        command.reads(arguments.camera.path);
    }
    RenderPlan plan{.name = name,
                    .cameras = options::FrameCameras(arguments.camera),
                    .options = options,
                    .views = options::ViewsPlan(arguments.views, options.width, options.height)};
    requireOneView(arguments, plan);
    requireBending(arguments);
    if (!arguments.certify.empty() && arguments.aov == output::Aov::linear) {
        throw base::InputError("--certify repairs the encoded picture: leave out --aov linear");
    }
    checkFiles(arguments, plan, command.files());
    const ranks::Place& place = command.ranks().place();
    if (arguments.ranks == FrameDivision::cascades) {
        plan.options.part = {.index = place.index, .count = place.count};
    }
    if (!arguments.trace.empty() && !command.ranks().isAlone()) {
        throw base::InputError("--trace works in one process only: start it without mpirun");
    }
    if (!arguments.trace.empty() && !arguments.state.empty()) {
        throw base::InputError(
            "--trace needs all frames, and --state does not draw those that are kept: give one");
    }
    if (!arguments.certify.empty()) {
        output::requireCertifiable(plan.options);
    }
    return plan;
}

bool hasBlended(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const scene::Material& material) {
        return material.alphaMode == scene::AlphaMode::blend;
    });
}

std::vector<scene::Camera> camerasOf(const scene::CameraPath& path, const options::FrameCameras& cameras) {
    std::vector<scene::Camera> all;
    for (std::uint32_t frame = 0; frame < cameras.frames; ++frame) {
        all.push_back(cameras.at(path, cameras.first + frame));
    }
    return all;
}

/// The scene as it is drawn: in its colours, with levels of detail, and without what other ranks draw.
scene::SceneSetup openDrawn(Command& command, const RenderArguments& arguments, const RenderPlan& plan,
                            const WantedOfFrames& wanted, platform::WorkerPool& workers) {
    scene::SceneSetup setup = command.openScene(arguments.scene, arguments.seed,
                                                scenes::shownChoice(arguments.scene, arguments.choice));
    scenes::paint(setup.scene, arguments.scene, *arguments.colours);
    scenes::setLayers(setup.scene, arguments.layers.choices);
    // An unusable camera ends here, before the device is made.
    plan.views.camerasOf(plan.cameras.at(setup.path, plan.cameras.first));
    if (arguments.ranks == FrameDivision::cascades) {
        requireDivisible(plan.options,
                         {.blended = hasBlended(setup.scene)}); // one process refuses what several do
        if (plan.options.part.count > 1 && !setup.motion && !wanted.truth && !wanted.certificate) {
            dropOtherParts(setup.scene, plan.options, camerasOf(setup.path, plan.cameras), workers);
        }
    }
    visibility::prepareDetail(setup.scene, plan.options.detail.mode, workers);
    return setup;
}

/// Where the pictures are, or that there are none.
std::string whatWasWritten(const RenderArguments& arguments, const RenderPlan& plan) {
    const std::uint32_t frames = plan.cameras.frames;
    if (arguments.file.empty()) {
        return fmt::format("{} drawn, no picture written; -o FILE writes {}",
                           frames == 1 ? "one frame" : fmt::format("{} frames", frames),
                           frames == 1 ? "it" : "them");
    }
    const std::string first = plan.name.at(plan.cameras.first).string();
    return frames == 1 ? fmt::format("{} written", first)
                       : fmt::format("{} to {} written", first,
                                     plan.name.at(plan.cameras.first + frames - 1).string());
}

/// Draws all frames of the plan that no earlier run has made, and brings all into the results.
void drawFrames(Command& command, const RenderArguments& arguments, const RenderPlan& plan,
                const scene::CameraPath& path, FrameMaker& maker, RenderResults& results) {
    const std::uint32_t first = plan.cameras.first;
    std::uint32_t next = first;
    const auto progress = command.progressOf(arguments.scene);
    const auto numberOf = [&](std::size_t frame) { return first + static_cast<std::uint32_t>(frame); };
    const auto draw = [&](std::size_t frame) {
        const std::uint32_t number = numberOf(frame);
        progress(frame, plan.cameras.frames);
        for (; next < number; ++next) {
            maker.skip(next, plan.cameras.at(path, next));
        }
        render::Frame drawn = maker.draw(next++, plan.cameras.at(path, number));
        command.opened().requireSilentValidation();
        return drawn;
    };
    const auto describe = [&](std::size_t frame, render::Frame drawn) {
        return results.describe(frame, maker.finish(numberOf(frame), std::move(drawn)));
    };
    const auto drawMerged = [&](std::size_t frame) {
        render::Frame drawn = draw(frame);
        std::size_t bytesSent = 0;
        runs::mergeParts(command.ranks(), drawn, bytesSent);
        return command.ranks().isFirst() ? describe(frame, std::move(drawn)) : output::Json();
    };
    const auto take = [&](std::size_t frame, const output::Json& made) { results.take(frame, made); };
    if (arguments.ranks == FrameDivision::frames) {
        runs::forEachUnit(
            command.ranks(), plan.cameras.frames,
            [&](std::size_t frame) { return describe(frame, draw(frame)); }, take);
    } else {
        runs::forEachUnit(command.ranks(), plan.cameras.frames, drawMerged, take,
                          &ranks::Ranks::forEachUnitTogether);
    }
    command.endProgress();
}

/// Who deforms what does; none where nothing does.
std::optional<scenes::Deform> deformOf(Command& command, const RenderArguments& arguments,
                                       const scene::SceneMotion& motion, const WantedOfFrames& wanted) {
    if (motion.meshes.empty()) {
        return std::nullopt;
    }
    const bool cpuReads =
        wanted.truth || wanted.certificate || arguments.drawing.surface != render::SurfacePath::gbuffer;
    return options::deformOn(command.device().info(), arguments.deform,
                             cpuReads ? options::VertexReaders::drawingAndCpu
                                      : options::VertexReaders::drawing);
}

void runRender(Command& command, RenderArguments& arguments) {
    RenderPlan plan = planOf(command, arguments);
    std::optional<platform::Trace> trace;
    if (!arguments.trace.empty()) {
        plan.options.trace = &trace.emplace(plan.options.threads);
    }
    const bool finishes = arguments.ranks == FrameDivision::frames || command.ranks().isFirst();
    const WantedOfFrames wanted{.truth = arguments.aov == output::Aov::wrong && finishes,
                                .certificate = !arguments.certify.empty() && finishes};
    platform::WorkerPool workers(arguments.drawing.threads);
    scene::SceneSetup setup = openDrawn(command, arguments, plan, wanted, workers);
    command.openState(arguments.state);
    arguments.deform = deformOf(command, arguments, setup.motion, wanted);
    std::optional<scenes::MovingScene> moving;
    if (setup.motion) {
        moving.emplace(std::move(setup.scene), setup.motion, arguments.deform.value_or(scenes::Deform::cpu));
    }
    FrameMaker maker(command.device(), moving ? moving->world().scene() : setup.scene,
                     moving ? &*moving : nullptr, plan.options, plan.views, wanted, workers);
    RenderResults results(command, arguments, plan.options, plan.views, plan.name, plan.cameras);
    drawFrames(command, arguments, plan, setup.path, maker, results);
    if (trace) {
        trace->write(arguments.trace);
    }
    results.finish(whatWasWritten(arguments, plan));
}

} // namespace

void addRender(CLI::App& program, const GlobalOptions& global) {
    addCommand<RenderArguments>(program, global, "render", "Render a scene into pictures", addRenderOptions,
                                runRender, RankUse::all);
}

} // namespace cdr::cli
