#include "startup.h"

#include <cdr/base/error.h>
#include <cdr/image/picture_size.h>
#include <viewer/state/command_line.h>
#include <viewer/window/window.h>

#include <fmt/format.h>

namespace cdr::viewer {

namespace {

void chooseTechniques(const Arguments& arguments, ViewSettings& settings) {
    const std::size_t comma = arguments.compare.find(',');
    if (!arguments.depth.empty() || !arguments.split.empty()) {
        if (!arguments.technique.empty() || arguments.compare != Arguments{}.compare) {
            throw base::InputError("give either --technique or --compare, or --depth and --split");
        }
        settings.technique.mapping =
            depth::parseMapping(arguments.depth.empty() ? "standard" : arguments.depth);
        settings.technique.split = depth::parseSplit(arguments.split.empty() ? "none" : arguments.split);
    } else if (!arguments.technique.empty()) {
        settings.technique = depth::parseTechnique(arguments.technique);
    } else if (comma != std::string::npos) {
        settings.technique = depth::parseTechnique(arguments.compare.substr(0, comma));
        settings.second = depth::parseTechnique(arguments.compare.substr(comma + 1));
    } else {
        throw base::InputError(
            fmt::format("--compare must be LEFT,RIGHT, not '{}'", arguments.compare.substr(0, 60)));
    }
}

ViewSettings settingsOf(const Arguments& arguments) {
    ViewSettings settings;
    settings.scene = arguments.scene;
    settings.seed = arguments.seed;
    const char* colours = arguments.output.empty() ? "bright" : "thesis";
    settings.colours = scenes::parseColours(arguments.colours.empty() ? colours : arguments.colours);
    settings.layers = scenes::parseLayers(arguments.layers);
    settings.targets = render::parseTargets(arguments.targets);
    settings.submission = render::parseSubmission(arguments.submission);
    settings.batching = render::parseBatching(arguments.batching);
    settings.snapping = render::parseSnapping(arguments.snapping);
    settings.threads = arguments.threads;
    settings.choice = arguments.choice;
    settings.choice.light = options::lightOf(arguments.effects);
    settings.view = viewOfAov(arguments.aov);
    settings.finish = {.detail = visibility::parseDetail(arguments.detail),
                       .translucency = options::translucencyOf(arguments.effects),
                       .shadows = options::shadowsOf(arguments.effects),
                       .effects = options::effectsOf(arguments.effects),
                       .focus = options::focusOf(arguments.effects)};
    settings.views = arguments.views;
    options::ViewsPlan(settings.views, 1, 1); // refuses what contradicts itself
    chooseTechniques(arguments, settings);
    return settings;
}

} // namespace

ViewerModel initialModel(const Arguments& arguments) {
    ViewerModel model;
    ViewSettings& settings = model.settings;
    settings = settingsOf(arguments);
    model.interface.showsPanel = arguments.output.empty();
    if (!arguments.format.empty()) {
        settings.technique.format = depth::parseDepthFormat(arguments.format);
        if (settings.second) {
            settings.second->format = settings.technique.format;
        }
    }
    model.camera.playback = playbackOf(settings.choice, arguments.camera.frame);
    model.camera.playback.isPlaying = arguments.plays;
    model.camera.motion = arguments.plays ? Motion::scenePath : Motion::free;
    if (!arguments.camera.path.empty()) {
        model.camera.recorder.load(scene::readRecording(arguments.camera.path));
        model.camera.motion = Motion::recording;
    }
    model.interface.unit = base::parseLengthUnit(arguments.unit);
    model.camera.first = arguments.camera;
    if (arguments.isFirstUse) {
        model.interface.firstSteps.begin();
    }
    return model;
}

PictureExtent windowSize(const Arguments& arguments) {
    const auto size = image::parsePictureSize(arguments.size);
    constexpr auto kMax = static_cast<std::uint32_t>(kMaxWindowSide);
    if (!size || size->width > kMax || size->height > kMax) {
        throw base::InputError(fmt::format("size must be WIDTHxHEIGHT, 1 to {}, such as 1280x720, not '{}'",
                                           kMaxWindowSide, arguments.size.substr(0, 60)));
    }
    return {.width = size->width, .height = size->height};
}

std::filesystem::path freeName(const std::string& stem, const std::string& extension) {
    constexpr int kMaxNumbers = 10'000;
    for (int number = 1; number < kMaxNumbers; ++number) {
        std::filesystem::path name = fmt::format("{}-{:04}{}", stem, number, extension);
        if (!std::filesystem::exists(name)) {
            return name;
        }
    }
    throw base::InputError(fmt::format("no free name {}-NNNN{} here", stem, extension));
}

} // namespace cdr::viewer
