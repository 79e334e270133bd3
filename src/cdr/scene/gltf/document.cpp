#include "document.h"

#include "bytes/meshopt.h"
#include "checks.h"
#include "draco/extension.h"
#include "instancing.h"
#include "json.h"
#include "nodes/lights.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 9> kSupportedExtensions{kInstancing,
                                                               kDraco,
                                                               kLights,
                                                               kMeshopt,
                                                               "KHR_materials_emissive_strength",
                                                               "KHR_materials_unlit",
                                                               "KHR_mesh_quantization",
                                                               kVisibility,
                                                               "KHR_texture_transform"};

bool isSupported(const std::string& extension) {
    return std::ranges::find(kSupportedExtensions, extension) != kSupportedExtensions.end();
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

/// Names of extensions that are not drawn, each once, in the order in which they come up.
class UnusedExtensions {
  public:
    explicit UnusedExtensions(Notes& notes) : m_notes(notes) {}

    void add(const std::string& name) {
        if (!isSupported(name) && m_names.insert(name).second) {
            m_notes.addNamed("extension not used", name);
        }
    }

    /// Adds those that objects name. Files forget to list them. Recursion is bounded by parseBoundedJson().
    void addFrom(const json& value) {
        for (const auto& [key, child] : value.items()) {
            if (value.is_object() && key == "extensions" && child.is_object()) {
                for (const auto& [name, extension] : child.items()) {
                    add(name);
                }
            }
            if (child.is_structured() && key != "extras") {
                addFrom(child);
            }
        }
    }

  private:
    Notes& m_notes;
    std::set<std::string> m_names;
};

void requireSupportedExtensions(const json& root, Notes& notes) {
    for (const json& name : arrayMember(root, "extensionsRequired")) {
        const std::string extension = requireString(name, "extensionsRequired");
        if (!isSupported(extension)) {
            refuse("requires the extension {}, which is not supported", oneLine(extension));
        }
    }
    UnusedExtensions unused(notes);
    for (const json& name : arrayMember(root, "extensionsUsed")) {
        unused.add(requireString(name, "extensionsUsed"));
    }
    unused.addFrom(root);
}

void requireBoundedArrays(const json& root, const GltfLimits& limits) {
    constexpr std::size_t kMaxEntries = 1'000'000;
    // Each of these becomes memory, a file that is read, or a resource of the device.
    constexpr std::size_t kMaxLargeEntries = 65'536;
    // Each primitive may look through them. There are fewer that are supported.
    constexpr std::size_t kMaxRequired = 64;
    const auto require = [&root](const char* key, std::size_t limit) {
        if (arrayMember(root, key).size() > limit) {
            refuse("{} {} are over the limit of {}", arrayMember(root, key).size(), key, limit);
        }
    };
    require("extensionsRequired", kMaxRequired);
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

json parseDocument(std::string_view text, const GltfLimits& limits, Notes& notes) {
    json root = parseBoundedJson(text);
    if (!root.is_object()) {
        refuse("its JSON is not an object");
    }
    requireVersion2(root);
    requireBoundedArrays(root, limits);
    requireSupportedExtensions(root, notes);
    return root;
}

} // namespace cdr::scene::gltf
