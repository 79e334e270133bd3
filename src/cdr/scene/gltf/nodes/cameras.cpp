#include "cameras.h"

#include "../checks.h"
#include "../json.h"

#include <cdr/scene/animation/node_camera.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

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

CameraLens lensOf(const json& camera, const std::string& where) {
    const json* perspective = member(camera, "perspective");
    if (perspective == nullptr || !perspective->is_object()) {
        refuse("{}: has no 'perspective' object", where);
    }
    const auto fovY = positive(*perspective, "yfov", std::numbers::pi, where);
    const auto nearView = positive(*perspective, "znear", INFINITY, where);
    const auto farView = positive(*perspective, "zfar", INFINITY, where);
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
    const json* orthographic = member(camera, "orthographic");
    if (orthographic == nullptr || !orthographic->is_object()) {
        refuse("{}: has no 'orthographic' object", where);
    }
    const auto halfHeight = positive(*orthographic, "ymag", INFINITY, where);
    const auto nearView = numberMember(*orthographic, "znear", where);
    const auto farView = positive(*orthographic, "zfar", INFINITY, where);
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

} // namespace

std::vector<CameraLens> takeLenses(const json& root) {
    std::vector<CameraLens> lenses;
    for (const json& camera : arrayMember(root, "cameras")) {
        const std::string where = fmt::format("camera {} '{}'", lenses.size(), nameOf(camera));
        const std::string type = stringMember(camera, "type").value_or("");
        if (type == "perspective") {
            lenses.push_back(lensOf(camera, where));
        } else if (type == "orthographic") {
            lenses.push_back(orthographicLensOf(camera, where));
        } else {
            refuse("{}: type '{}' does not exist", where, oneLine(type));
        }
    }
    return lenses;
}

std::vector<GltfCamera> placeCameras(std::span<const CameraNode> nodes, const Document& document,
                                     Notes& notes) {
    std::vector<GltfCamera> cameras;
    for (const CameraNode& node : nodes) {
        const CameraLens& lens = itemAt(document.lenses, node.camera, "camera");
        const auto camera = carriedBy(node.toWorld, seenThrough(lens));
        if (!camera) {
            notes.add("a camera is not used, because its transform is not invertible",
                      fmt::format("node {}", node.node));
            continue;
        }
        const std::string nodeName = oneLine(fullNameOf(itemAt(document.root, "nodes", node.node, "node")));
        cameras.push_back({!lens.name.empty() ? lens.name : nodeName, *camera, node.node, lens.orthographic});
    }
    // Others keep the numbers that they had before these were drawn.
    std::stable_partition(cameras.begin(), cameras.end(),
                          [](const GltfCamera& camera) { return !camera.orthographic; });
    return cameras;
}

} // namespace cdr::scene::gltf
