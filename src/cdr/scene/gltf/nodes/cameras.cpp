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

GltfCamera perspectiveOf(const json& camera, const std::string& where) {
    const json& perspective = objectMember(camera, "perspective", where);
    const auto fovY = positive(perspective, "yfov", INFINITY, where); // glTF advises to stay below pi
    const auto nearView = positive(perspective, "znear", INFINITY, where);
    const auto farView = positive(perspective, "zfar", INFINITY, where);
    if (!fovY || !nearView || (farView && *farView <= *nearView)) {
        refuse("{}: needs a yfov, and a znear that lies before its zfar", where);
    }
    return {.name = oneLine(fullNameOf(camera)),
            .camera = {.fovY = *fovY,
                       .nearView = *nearView,
                       .farView = farView.value_or(kGltfFarRatio * *nearView)},
            .orthographic = {}};
}

GltfCamera orthographicOf(const json& camera, const std::string& where) {
    const json& orthographic = objectMember(camera, "orthographic", where);
    const auto halfHeight = magnification(orthographic, "ymag", where);
    const auto nearView = numberMember(orthographic, "znear", where);
    const auto farView = positive(orthographic, "zfar", INFINITY, where);
    if (!halfHeight || !nearView || !farView || !(*nearView >= 0.0 && *nearView < *farView)) {
        refuse("{}: needs a ymag, and a znear of at least 0 that lies before its zfar", where);
    }
    return {.name = oneLine(fullNameOf(camera)),
            .camera = {},
            .orthographic =
                OrthographicLens{.halfHeight = *halfHeight, .nearView = *nearView, .farView = *farView}};
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

/// A camera of the file as it stands at the origin.
GltfCamera cameraOf(const json& root, int index) {
    const json& camera = itemAt(root, "cameras", index, "camera");
    const std::string where = labelOfCamera(root, index);
    const std::string type = stringMember(camera, "type").value_or("");
    if (type == "perspective") {
        return perspectiveOf(camera, where);
    }
    if (type == "orthographic") {
        return orthographicOf(camera, where);
    }
    refuse("{}: type '{}' does not exist", where, oneLine(type));
}

} // namespace

std::vector<GltfCamera> placeCameras(std::span<const CameraNode> nodes, const json& root, Notes& notes) {
    std::vector<GltfCamera> cameras;
    std::map<int, GltfCamera> sources; // by camera of the file, which many nodes may have
    for (const CameraNode& node : nodes) {
        const auto [found, isNew] = sources.try_emplace(node.camera);
        if (isNew) {
            found->second = cameraOf(root, node.camera);
        }
        const GltfCamera& source = found->second;
        const auto camera = carriedBy(node.toWorld, source.camera);
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
        cameras.push_back(
            {!source.name.empty() ? source.name : nodeName, *camera, node.node, source.orthographic});
    }
    // Others keep the numbers that they had before these were drawn.
    std::stable_partition(cameras.begin(), cameras.end(),
                          [](const GltfCamera& camera) { return !camera.orthographic; });
    return cameras;
}

} // namespace cdr::scene::gltf
