#include "camera_options.h"

#include "help_texts.h"
#include "parsed_option.h"

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/camera_recording.h>

#include <limits>

namespace cdr::options {

namespace {

constexpr const char* kOfScene = "that of the scene's camera";

glm::dvec3 parsePoint(const std::string& what, const std::string& text) {
    const std::size_t first = text.find(',');
    const std::size_t second = first == std::string::npos ? first : text.find(',', first + 1);
    if (second == std::string::npos) {
        throw base::inputError("{} must be three numbers x,y,z, not '{}'", what, text.substr(0, 60));
    }
    return {base::parseNumber(what, text.substr(0, first)),
            base::parseNumber(what, text.substr(first + 1, second - first - 1)),
            base::parseNumber(what, text.substr(second + 1))};
}

glm::dvec2 parseLensShift(const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) {
        throw base::inputError("--lens-shift must be two numbers x,y, not '{}'", text.substr(0, 60));
    }
    return {base::parseNumber("--lens-shift", text.substr(0, comma)),
            base::parseNumber("--lens-shift", text.substr(comma + 1))};
}

CLI::Option* addPoint(CLI::App& command, const char* name, std::optional<glm::dvec3>& point,
                      const char* help) {
    return addParsed(
               command, name, point, [name](const std::string& text) { return parsePoint(name, text); }, help)
        ->type_name("X,Y,Z");
}

/// The camera where and as the options say it stands; as it is where they say nothing.
scene::Camera placed(const scene::Camera& camera, const CameraOptions& options) {
    if (!options.eye && !options.target && !options.direction && !options.up) {
        return camera;
    }
    const glm::dvec3 eye = options.eye.value_or(camera.position);
    glm::dvec3 forward = -camera.back; // without target and direction, it stays
    if (options.target) {
        const scene::Camera looking = scene::lookAt(camera, eye, *options.target);
        if (!options.up) {
            return looking;
        }
        forward = -looking.back;
    } else if (options.direction) {
        forward = *options.direction;
    }
    return options.up ? scene::lookAlong(camera, eye, forward, *options.up)
                      : scene::lookAlong(camera, eye, forward);
}

} // namespace

void addFrameOptions(CLI::App& command, CameraOptions& options) {
    addValue(command, "--frame", options.frame, "First frame of the scene's camera path");
    command.add_option("--frames", options.frames, "Number of frames")
        ->check(CLI::Range(1u, kMaxFrames))
        ->default_str("1, or with --path all that were recorded");
}

void addCameraOptions(CLI::App& command, CameraOptions& options) {
    CLI::Option* path = addFile(command, "--path", options.path,
                                "Camera path that cdr-viewer recorded, instead of the scene's own");
    CLI::Option* eye =
        addPoint(command, "--eye", options.eye, "Position of the camera, instead of the scene's own");
    CLI::Option* target = addPoint(command, "--target", options.target, "Point that the camera looks at");
    CLI::Option* direction =
        addPoint(command, "--direction", options.direction,
                 "Direction in which the camera looks; exact at any distance from the origin");
    CLI::Option* up = addPoint(command, "--up", options.up, "Direction that is up in the picture");
    up->default_str("the y axis, if --eye, --target or --direction is given");
    target->excludes(direction);
    for (CLI::Option* place : {eye, target, direction, up}) {
        place->excludes(path);
    }
    if (CLI::Option* frame = command.get_option_no_throw("--frame")) {
        frame->excludes(path);
    }
    command.add_option("--fov", options.fovDegrees, kFovHelp)->default_str(kOfScene);
    addParsed(
        command, "--lens-shift", options.lensShift, parseLensShift,
        "How far the centre of the picture is to the right of the view axis and above it, at distance 1")
        ->type_name("X,Y")
        ->default_str(kOfScene);
    command.add_option("--near", options.nearView, kNearHelp)->default_str(kOfScene);
    command.add_option("--far", options.farView, kFarHelp)->default_str(kOfScene);
}

FrameCameras::FrameCameras(const CameraOptions& options)
    : first(options.frame),
      frames(options.frames.value_or(1)),
      m_options(options) {
    if (options.path.empty()) {
        if (frames - 1 > std::numeric_limits<std::uint32_t>::max() - first) {
            throw base::inputError("--frame {} --frames {}: the last frame's number is at most {}", first,
                                   frames, std::numeric_limits<std::uint32_t>::max());
        }
        return;
    }
    const scene::CameraRecording recording = scene::readRecording(options.path);
    frames = options.frames.value_or(static_cast<std::uint32_t>(recording.cameras.size()));
    m_recorded = scene::pathOf(recording, frames);
}

scene::Camera FrameCameras::at(const scene::CameraPath& own, std::uint32_t frame) const {
    return overridden(m_recorded ? m_recorded->at(frame) : own.at(frame), m_options);
}

CameraOptions lensOf(const CameraOptions& options) {
    CameraOptions lens;
    lens.fovDegrees = options.fovDegrees;
    lens.lensShift = options.lensShift;
    lens.nearView = options.nearView;
    lens.farView = options.farView;
    return lens;
}

scene::Camera overridden(scene::Camera camera, const CameraOptions& options) {
    if (options.fovDegrees) {
        camera.fovY = scene::radiansOf(*options.fovDegrees);
    }
    camera.lensShift = options.lensShift.value_or(camera.lensShift);
    camera.nearView = options.nearView.value_or(camera.nearView);
    camera.farView = options.farView.value_or(camera.farView);
    scene::requireUsable(camera);
    return placed(camera, options);
}

} // namespace cdr::options
