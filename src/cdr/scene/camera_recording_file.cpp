#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>
#include <cdr/scene/camera_recording.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "cdr camera path";
constexpr int kFormatVersion = 1;
constexpr int kDeepest = 4; // recording, cameras, camera, vector, number
/// A camera takes about 500 bytes.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{kMaxRecordedCameras} * 640;
constexpr std::size_t kMaxSceneName = 4096;
/// How far axes may be from orthonormal: far above roundings, far below what can be seen.
constexpr double kAxesTolerance = 1e-9;

Json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json toJson(const RecordedCamera& recorded) {
    const Camera& camera = recorded.camera;
    Json json{{"seconds", recorded.seconds},   {"position", toJson(camera.position)},
              {"right", toJson(camera.right)}, {"up", toJson(camera.up)},
              {"back", toJson(camera.back)},   {"fov_radians", camera.fovY},
              {"near", camera.nearView},       {"far", camera.farView}};
    if (camera.lensShift != glm::dvec2(0.0)) {
        json["lens_shift"] = {camera.lensShift.x, camera.lensShift.y};
    }
    return json;
}

double numberIn(const nlohmann::json& json, const char* key) {
    const nlohmann::json& value = json.at(key);
    if (!value.is_number()) {
        throw base::inputError("{} must be a number", key);
    }
    return value.get<double>();
}

/// N numbers, two or three.
template <int N>
glm::vec<N, double> numbersIn(const nlohmann::json& json, const char* key) {
    const nlohmann::json& value = json.at(key);
    if (!value.is_array() || value.size() != N || !std::ranges::all_of(value, &nlohmann::json::is_number)) {
        throw base::inputError("{} must be {} numbers", key, N == 3 ? "three" : "two");
    }
    glm::vec<N, double> numbers(0.0);
    std::copy(value.begin(), value.end(), &numbers.x);
    return numbers;
}

void requireOrthonormal(const Camera& camera) {
    const std::array<glm::dvec3, 3> axes{camera.right, camera.up, camera.back};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        for (std::size_t j = i; j < axes.size(); ++j) {
            // Written so that NaN fails.
            if (!(std::abs(glm::dot(axes[i], axes[j]) - (i == j ? 1.0 : 0.0)) <= kAxesTolerance)) {
                throw base::InputError("right, up and back must be orthonormal");
            }
        }
    }
    if (glm::dot(glm::cross(camera.up, camera.back), camera.right) < 0.0) {
        throw base::InputError("right, up and back must be right-handed");
    }
}

RecordedCamera cameraIn(const nlohmann::json& json) {
    const RecordedCamera recorded{.seconds = numberIn(json, "seconds"),
                                  .camera = {.position = numbersIn<3>(json, "position"),
                                             .right = numbersIn<3>(json, "right"),
                                             .up = numbersIn<3>(json, "up"),
                                             .back = numbersIn<3>(json, "back"),
                                             .fovY = numberIn(json, "fov_radians"),
                                             .nearView = numberIn(json, "near"),
                                             .farView = numberIn(json, "far"),
                                             .lensShift = json.contains("lens_shift")
                                                              ? numbersIn<2>(json, "lens_shift")
                                                              : glm::dvec2(0.0)}};
    requireOrthonormal(recorded.camera); // says more than requireUsable() about axes
    requireUsable(recorded.camera);
    return recorded;
}

/// Cameras between the two have numbers for positions.
bool hasWayBetween(const Camera& before, const Camera& after) {
    const glm::dvec3 way = after.position - before.position;
    return std::isfinite(way.x) && std::isfinite(way.y) && std::isfinite(way.z);
}

CameraRecording recordingIn(const nlohmann::json& json) {
    if (!json.is_object() || json.value("format", "") != kFormat) {
        throw base::InputError("is not a camera path of cdr-viewer");
    }
    if (json.at("version") != kFormatVersion) {
        throw base::inputError("has another version than {}", kFormatVersion);
    }
    const nlohmann::json& cameras = json.at("cameras");
    if (!cameras.is_array() || cameras.empty() || cameras.size() > kMaxRecordedCameras) {
        throw base::inputError("must hold 1 to {} cameras", kMaxRecordedCameras);
    }
    CameraRecording recording{.scene = json.at("scene").get<std::string>(), .cameras = {}};
    if (recording.scene.size() > kMaxSceneName) {
        throw base::InputError("the scene's name is too long");
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        try {
            recording.cameras.push_back(cameraIn(cameras[i]));
        } catch (const base::InputError& error) {
            throw base::inputError("camera {}: {}", i, error.what());
        }
        const double seconds = recording.seconds();
        if (!(seconds >= 0.0) || !std::isfinite(seconds) ||
            (i > 0 && seconds <= recording.cameras[i - 1].seconds)) {
            throw base::inputError("camera {}: seconds must be finite and ascend from 0 on", i);
        }
        if (i > 0 && !hasWayBetween(recording.cameras[i - 1].camera, recording.cameras[i].camera)) {
            throw base::inputError("camera {}: it is too far from the one before", i);
        }
    }
    return recording;
}

} // namespace

void writeRecording(const std::filesystem::path& path, const CameraRecording& recording) {
    Json cameras = Json::array();
    for (const RecordedCamera& camera : recording.cameras) {
        cameras.push_back(toJson(camera));
    }
    const Json json{{"format", kFormat},
                    {"version", kFormatVersion},
                    {"scene", recording.scene},
                    {"cameras", std::move(cameras)}};
    platform::writeText(path, platform::textOf(json, 1)); // a scene's path need not be UTF-8
}

CameraRecording readRecording(const std::filesystem::path& path) {
    const platform::Bytes bytes = platform::readFile(path, kMaxBytes);
    try {
        return recordingIn(
            platform::parseShallow<nlohmann::json>(bytes, kDeepest, "is not a camera path of cdr-viewer"));
    } catch (const base::InputError& error) {
        throw base::inputError("{}: {}", platform::oneLine(path), error.what());
    } catch (const nlohmann::json::exception&) {
        throw base::InputError(platform::oneLine(path) + ": is not a camera path of cdr-viewer, or damaged");
    }
}

} // namespace cdr::scene
