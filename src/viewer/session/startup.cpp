#include "startup.h"

#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <cdr/render/renderer_setup.h>
#include <viewer/state/camera/stereo_view.h>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace cdr::viewer {

namespace {

void chooseTechniques(const Arguments& arguments, ViewSettings& settings) {
    if (arguments.parts.isGiven()) {
        if (arguments.technique || arguments.compare) {
            throw base::InputError("give either --technique or --compare, or --depth and --split");
        }
        settings.technique = arguments.parts.technique();
    } else if (arguments.technique) {
        settings.technique = *arguments.technique;
    } else {
        const auto [left, right] = arguments.compare.value_or(parsePair(kCompared));
        settings.technique = left;
        settings.second = right;
    }
    if (arguments.format) {
        settings.technique.format = *arguments.format;
        if (settings.second) {
            settings.second->format = *arguments.format;
        }
    }
}

/// What would end the viewer later ends it before its window opens.
void requireUsable(const Arguments& arguments) {
    requireCompatible(arguments.settings.drawing); // panels may leave unused what a command line may not
    scene::requireUsable(arguments.settings.choice);
    if (!arguments.screenshot.empty()) {
        image::requireEncodable(arguments.screenshot);
        platform::requireWritable(arguments.screenshot);
    }
}

ViewSettings settingsOf(const Arguments& arguments) {
    ViewSettings settings = arguments.settings;
    settings.colours = arguments.colours.value_or(arguments.output.empty() ? scenes::Colours::bright
                                                                           : scenes::Colours::thesis);
    settings.layers = arguments.layers.choices;
    settings.givenEyes = settings.views;
    options::ViewsPlan(settings.views, 1, 1); // refuses what contradicts itself
    chooseTechniques(arguments, settings);
    return settings;
}

/// A recording through the lens of the command line, as `cdr render` draws it.
scene::CameraRecording recordingOf(const options::CameraOptions& camera) {
    scene::CameraRecording recording = scene::readRecording(camera.path);
    for (scene::RecordedCamera& recorded : recording.cameras) {
        recorded.camera = options::overridden(recorded.camera, options::lensOf(camera));
    }
    return recording;
}

} // namespace

ViewerModel initialModel(const Arguments& arguments) {
    requireUsable(arguments);
    ViewerModel model;
    ViewSettings& settings = model.settings;
    settings = settingsOf(arguments);
    model.interface.showsPanel = arguments.output.empty();
    model.camera.playback = playbackOf(settings.choice, arguments.camera.frame);
    model.camera.playback.isPlaying = arguments.plays;
    model.camera.motion = arguments.plays ? Motion::scenePath : Motion::free;
    if (!arguments.camera.path.empty()) {
        model.camera.recorder.load(recordingOf(arguments.camera));
        model.camera.motion = Motion::recording;
    }
    model.interface.unit = arguments.unit;
    model.camera.first = arguments.camera;
    model.picture.device = arguments.device;
    if (arguments.isFirstUse) {
        model.interface.firstSteps.begin();
    }
    return model;
}

FirstSize firstSize(const Arguments& arguments, const ViewSettings& settings) {
    const bool isOfPicture = !arguments.output.empty();
    const PictureExtent told = arguments.size.value_or(PictureExtent{.width = 1280, .height = 720});
    FirstSize size{.width = told.width, .height = told.height, .isScaled = !arguments.size && !isOfPicture};
    if (isOfPicture && stereoPictureOf(settings) == options::StereoPicture::sideBySide) {
        size.width = std::min(2 * size.width, static_cast<std::uint32_t>(kMaxWindowSide)); // it is one eye's
    }
    return size;
}

std::filesystem::path freeName(const std::string& stem, const std::string& extension) {
    constexpr int kMaxNumbers = 10'000;
    for (int number = 1; number < kMaxNumbers; ++number) {
        std::filesystem::path name = fmt::format("{}-{:04}{}", stem, number, extension);
        std::error_code unknown; // a name that cannot be looked at counts as taken
        if (std::filesystem::status(name, unknown).type() == std::filesystem::file_type::not_found) {
            return name;
        }
    }
    throw base::inputError("no free name {}-NNNN{} here", stem, extension);
}

} // namespace cdr::viewer
