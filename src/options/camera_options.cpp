#include "camera_options.h"

#include "number_checks.h"

#include <CLI/CLI.hpp>
#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/camera_recording.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace cdr::options {

namespace {

glm::dvec3 parsePoint(const std::string& what, const std::string& text) {
    const std::size_t first = text.find(',');
    const std::size_t second = first == std::string::npos ? first : text.find(',', first + 1);
    if (second == std::string::npos) {
        throw base::InputError(
            fmt::format("{} must be three numbers x,y,z, not '{}'", what, text.substr(0, 60)));
    }
    return {base::parseNumber(what, text.substr(0, first)),
            base::parseNumber(what, text.substr(first + 1, second - first - 1)),
            base::parseNumber(what, text.substr(second + 1))};
}

glm::dvec2 parseLensShift(const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) {
        throw base::InputError(
            fmt::format("--lens-shift must be two numbers x,y, not '{}'", text.substr(0, 60)));
    }
    return {base::parseNumber("--lens-shift", text.substr(0, comma)),
            base::parseNumber("--lens-shift", text.substr(comma + 1))};
}

/// The camera where and as the options say it stands; as it is where they say nothing.
scene::Camera placed(const scene::Camera& camera, const CameraOptions& options) {
    if (options.eye.empty() && options.target.empty() && options.direction.empty() && options.up.empty()) {
        return camera;
    }
    const glm::dvec3 eye = options.eye.empty() ? camera.position : parsePoint("--eye", options.eye);
    glm::dvec3 forward = -camera.back; // without target and direction, it stays
    if (!options.target.empty()) {
        const scene::Camera looking = scene::lookAt(camera, eye, parsePoint("--target", options.target));
        if (options.up.empty()) {
            return looking;
        }
        forward = -looking.back;
    } else if (!options.direction.empty()) {
        forward = parsePoint("--direction", options.direction);
    }
    return options.up.empty() ? scene::lookAlong(camera, eye, forward)
                              : scene::lookAlong(camera, eye, forward, parsePoint("--up", options.up));
}

} // namespace

void addFrameOptions(CLI::App& command, CameraOptions& options) {
    command.add_option("--frame", options.frame, "First frame of the scene's camera path")
        ->capture_default_str();
    command.add_option("--frames", options.frames, "How many frames; 1, or with --path as many as recorded")
        ->check(CLI::Range(1u, kMaxFrames));
}

void addCameraOptions(CLI::App& command, CameraOptions& options) {
    CLI::Option* path = command.add_option("--path", options.path,
                                           "Camera path recorded by cdr-viewer, instead of the scene's");
    CLI::Option* eye =
        command.add_option("--eye", options.eye, "Camera position x,y,z instead of the scene's");
    CLI::Option* target = command.add_option("--target", options.target, "Point x,y,z to look at");
    CLI::Option* direction = command.add_option(
        "--direction", options.direction,
        "View direction x,y,z, instead of a target: exact at any distance from the origin");
    CLI::Option* up =
        command.add_option("--up", options.up, "Direction x,y,z that is up in the picture; else world y");
    target->excludes(direction);
    for (CLI::Option* place : {eye, target, direction, up}) {
        place->excludes(path);
    }
    if (CLI::Option* frame = command.get_option_no_throw("--frame")) {
        frame->excludes(path);
    }
    command.add_option("--fov", options.fovDegrees, "Vertical field of view in degrees");
    command.add_option(
        "--lens-shift", options.lensShift,
        "How far the middle of the picture lies to the right of the view axis and above it, at distance 1: "
        "x,y");
    command.add_option("--near", options.nearView, "Near plane, view distance");
    command.add_option("--far", options.farView, "Far plane, view distance");
}

void addColours(CLI::App& command, std::string& colours) {
    command.add_option("--colours", colours, "Of a generated scene: thesis (one grey) or bright")
        ->capture_default_str();
}

void addLayers(CLI::App& command, std::vector<std::string>& layers) {
    command
        .add_option(
            "--layer", layers,
            "MATERIAL=LAYER: decides between faces at one place. Those of the material count as nearer by "
            "LAYER scene units; MATERIAL is a name, or #N from 0. May be repeated")
        ->allow_extra_args(false);
}

void addTextureMemory(CLI::App& command, std::optional<std::uint64_t>& textureMiB) {
    command
        .add_option("--texture-memory", textureMiB,
                    "Most MiB of a glTF file's textures, which are shown smaller to fit")
        ->check(CLI::Range(std::uint64_t{1}, scene::kMaxTextureMiB));
}

void addPointRadius(CLI::App& command, std::optional<double>& radius) {
    command
        .add_option(
            "--points", radius,
            "Radius of a glTF file's points and lines, in scene units; else by how far they are apart")
        ->check(numberFrom(scene::kMinPointRadius, scene::kMaxPointRadius));
}

void addSceneChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--gltf-scene", choice.scene, "Scene of a glTF file, from 0; its default one");
    command.add_option("--camera", choice.camera,
                       "Look through a glTF scene's camera, from 0; else the view shows all of the scene");
}

void addAnimationChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--animation", choice.animation,
                       "Animation of a glTF file, by name or from 0; with --time or --fps the first");
    command.add_option("--time", choice.seconds, "Seconds of the animation at frame 0");
    command.add_option("--fps", choice.framesPerSecond,
                       "Frames of --frames to a second of the animation; else all show one moment");
}

FrameCameras::FrameCameras(const CameraOptions& options)
    : first(options.frame),
      frames(options.frames.value_or(1)),
      m_options(options) {
    if (options.path.empty()) {
        if (frames - 1 > std::numeric_limits<std::uint32_t>::max() - first) {
            throw base::InputError(
                fmt::format("--frame {} --frames {}: the last frame's number is at most {}", first, frames,
                            std::numeric_limits<std::uint32_t>::max()));
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

scene::Camera overridden(scene::Camera camera, const CameraOptions& options) {
    if (options.fovDegrees) {
        camera.fovY = scene::radiansOf(*options.fovDegrees);
    }
    if (!options.lensShift.empty()) {
        camera.lensShift = parseLensShift(options.lensShift);
    }
    camera.nearView = options.nearView.value_or(camera.nearView);
    camera.farView = options.farView.value_or(camera.farView);
    scene::requireUsable(camera);
    return placed(camera, options);
}

} // namespace cdr::options
