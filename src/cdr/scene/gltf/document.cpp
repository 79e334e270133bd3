#include "document.h"

#include "cameras.h"
#include "checks.h"
#include "compression.h"
#include "json.h"
#include "tinygltf.h"

#include <nlohmann/json.hpp>

#include <array>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kSupportedExtensions{"KHR_materials_unlit", "KHR_mesh_quantization",
                                                               "KHR_texture_transform"};

bool isSupported(const std::string& extension) {
    return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), extension) !=
           kSupportedExtensions.end();
}

void requireVersion2(const json& root) {
    const json* asset = member(root, "asset");
    if (asset == nullptr || !asset->is_object()) {
        refuse("no 'asset' object, this is not glTF 2.0");
    }
    const std::string version = stringMember(*asset, "version").value_or("");
    const std::string needed = stringMember(*asset, "minVersion").value_or("2.0");
    if (!version.starts_with("2.") || needed != "2.0") {
        refuse("glTF version '{}' (at least '{}') is not supported, only 2.0", oneLine(version),
               oneLine(needed));
    }
}

void requireSupportedExtensions(const json& root, Notes& notes) {
    for (const json& name : arrayMember(root, "extensionsRequired")) {
        const std::string extension = requireString(name, "extensionsRequired");
        if (!isSupported(extension)) {
            refuse("requires the extension {}, which is not supported", oneLine(extension));
        }
    }
    for (const json& name : arrayMember(root, "extensionsUsed")) {
        const std::string extension = requireString(name, "extensionsUsed");
        if (!isSupported(extension)) {
            notes.add("extension not used", extension);
        }
    }
}

void noteUnusedParts(const json& root, Notes& notes) {
    for (const json& animation : arrayMember(root, "animations")) {
        notes.add("animations are not played", fmt::format("animation '{}'", nameOf(animation)));
    }
    for (const json& skin : arrayMember(root, "skins")) {
        notes.add("skins are drawn in bind pose", fmt::format("skin '{}'", nameOf(skin)));
    }
}

std::vector<DataSource> takeBuffers(const json& root) {
    std::vector<DataSource> buffers;
    for (const json& buffer : arrayMember(root, "buffers")) {
        const std::optional<int> byteLength = indexMember(buffer, "byteLength");
        if (!byteLength || *byteLength == 0) {
            refuse("buffer {} has no byteLength", buffers.size());
        }
        buffers.push_back(
            {nameOf(buffer), stringMember(buffer, "uri"), -1, static_cast<std::size_t>(*byteLength)});
    }
    return buffers;
}

std::vector<DataSource> takeImages(const json& root) {
    std::vector<DataSource> images;
    for (const json& image : arrayMember(root, "images")) {
        const std::optional<int> bufferView = indexMember(image, "bufferView");
        std::optional<std::string> uri = stringMember(image, "uri");
        if (bufferView.has_value() == uri.has_value()) {
            refuse("image {} must have one of 'uri' and 'bufferView'", images.size());
        }
        images.push_back({nameOf(image), std::move(uri), bufferView.value_or(-1), 0});
    }
    return images;
}

void requireBoundedArrays(const json& root, const GltfLimits& limits) {
    constexpr std::size_t kMaxEntries = 1'000'000;
    // tinygltf's structs of these are 1 to 2 kB each, even of an empty JSON object.
    constexpr std::size_t kMaxLargeEntries = 65'536;
    const auto require = [&root](const char* key, std::size_t limit) {
        if (arrayMember(root, key).size() > limit) {
            refuse("{} {} are over the limit of {}", arrayMember(root, key).size(), key, limit);
        }
    };
    require("nodes", limits.maxNodes);
    for (const char* key :
         {"accessors", "bufferViews", "meshes", "scenes", "animations", "skins", "cameras"}) {
        require(key, kMaxEntries);
    }
    for (const char* key : {"buffers", "images", "materials", "samplers", "textures"}) {
        require(key, kMaxLargeEntries);
    }
}

} // namespace

Document parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes) {
    json root = parseBoundedJson(text);
    if (!root.is_object()) {
        refuse("its JSON is not an object");
    }
    requireVersion2(root);
    requireBoundedArrays(root, limits);
    requireSupportedExtensions(root, notes);
    noteUnusedParts(root, notes);
    Document document;
    document.buffers = takeBuffers(root);
    document.images = takeImages(root);
    document.lenses = takeLenses(root, notes);
    for (const char* key : {"animations", "skins", "cameras", "buffers", "images", "extensions", "extras"}) {
        root.erase(key);
    }
    requireSoundNumbers(root);
    requireUncompressed(root);
    document.model = parseModel(root.dump());
    return document;
}

} // namespace cdr::scene::gltf
