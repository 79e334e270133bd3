#include "cameras.h"

#include "../checks.h"
#include "../json.h"

#include <cdr/scene/animation/node_camera.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// What a camera of the file looks through.
struct CameraLens {
    std::string name{};
    double fovY = 0.0; ///< radians; 0 of an orthographic camera
    double nearView = 0.0;
    std::optional<double> farView{};                ///< none: infinitely far
    std::optional<OrthographicLens> orthographic{}; ///< instead
};

/// A positive number below `limit`; nothing when absent.
std::optional<double> positive(const json& object, const char* key, double limit, const std::string& where) {
    const json* value = member(object, key);
    if (value == nullptr) {
        return std::nullopt;
    }
    const double number = value->is_number() ? value->get<double>() : -1.0;
    if (!(number > 0.0 && number < limit)) {
        refuse("{}: its {} is {}, which no camera has", where, key, oneLine(value->dump()));
    }
    return number;
}

/// A number other than 0, as if it were positive: glTF advises against negative ones and lets them be.
std::optional<double> magnification(const json& object, const char* key, const std::string& where) {
    const std::optional<double> number = numberMember(object, key, where);
    if (number == 0.0) {
        refuse("{}: its {} is {}, which no camera has", where, key, oneLine(member(object, key)->dump()));
    }
    return number ? std::optional(std::abs(*number)) : std::nullopt;
}

CameraLens perspectiveLensOf(const json& camera, const std::string& where) {
    const json& perspective = objectMember(camera, "perspective", where);
    const auto fovY = positive(perspective, "yfov", INFINITY, where); // glTF advises to stay below pi
    const auto nearView = positive(perspective, "znear", INFINITY, where);
    const auto farView = positive(perspective, "zfar", INFINITY, where);
    if (!fovY || !nearView || (farView && *farView <= *nearView)) {
        refuse("{}: needs a yfov, and a znear that lies before its zfar", where);
    }
    return {.name = oneLine(fullNameOf(camera)),
            .fovY = *fovY,
            .nearView = *nearView,
            .farView = farView,
            .orthographic = {}};
}

CameraLens orthographicLensOf(const json& camera, const std::string& where) {
    const json& orthographic = objectMember(camera, "orthographic", where);
    const auto halfHeight = magnification(orthographic, "ymag", where);
    const auto nearView = numberMember(orthographic, "znear", where);
    const auto farView = positive(orthographic, "zfar", INFINITY, where);
    if (!halfHeight || !nearView || !farView || !(*nearView >= 0.0 && *nearView < *farView)) {
        refuse("{}: needs a ymag, and a znear of at least 0 that lies before its zfar", where);
    }
    return {.name = oneLine(fullNameOf(camera)),
            .fovY = 0.0,
            .nearView = *nearView,
            .farView = farView,
            .orthographic =
                OrthographicLens{.halfHeight = *halfHeight, .nearView = *nearView, .farView = *farView}};
}

/// What a camera looks through; an orthographic one stands there alone.
Camera seenThrough(const CameraLens& lens) {
    if (lens.orthographic) {
        return {};
    }
    return {.fovY = lens.fovY,
            .nearView = lens.nearView,
            .farView = lens.farView.value_or(kGltfFarRatio * lens.nearView)};
}

bool isUsable(const Camera& camera) {
    try {
        scene::requireUsable(camera);
        return true;
    } catch (const base::InputError&) {
        return false;
    }
}

/// A camera for messages.
std::string labelOfCamera(const json& root, int index) {
    return fmt::format("camera {} '{}'", index, nameOf(itemAt(root, "cameras", index, "camera")));
}

CameraLens lensOf(const json& root, int index) {
    const json& camera = itemAt(root, "cameras", index, "camera");
    const std::string where = labelOfCamera(root, index);
    const std::string type = stringMember(camera, "type").value_or("");
    if (type == "perspective") {
        return perspectiveLensOf(camera, where);
    }
    if (type == "orthographic") {
        return orthographicLensOf(camera, where);
    }
    refuse("{}: type '{}' does not exist", where, oneLine(type));
}

} // namespace

std::vector<GltfCamera> placeCameras(std::span<const CameraNode> nodes, const json& root, Notes& notes) {
    std::vector<GltfCamera> cameras;
    std::map<int, CameraLens> lenses; // by camera of the file, which many nodes may have
    for (const CameraNode& node : nodes) {
        const auto [found, isNew] = lenses.try_emplace(node.camera);
        if (isNew) {
            found->second = lensOf(root, node.camera);
        }
        const CameraLens& lens = found->second;
        const auto camera = carriedBy(node.toWorld, seenThrough(lens));
        if (!camera) {
            notes.add("a camera is not used, because its transform is not invertible",
                      fmt::format("node {}", node.node));
            continue;
        }
        if (!isUsable(*camera)) {
            notes.add("not used, because pictures have no such field of view, or no such distances",
                      labelOfCamera(root, node.camera));
            continue;
        }
        const std::string nodeName = oneLine(fullNameOf(itemAt(root, "nodes", node.node, "node")));
        cameras.push_back({!lens.name.empty() ? lens.name : nodeName, *camera, node.node, lens.orthographic});
    }
    // Others keep the numbers that they had before these were drawn.
    std::stable_partition(cameras.begin(), cameras.end(),
                          [](const GltfCamera& camera) { return !camera.orthographic; });
    return cameras;
}

} // namespace cdr::scene::gltf
