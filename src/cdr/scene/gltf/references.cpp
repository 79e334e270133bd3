#include "bytes/container.h"
#include "bytes/data_uri.h"
#include "bytes/files.h"
#include "json.h"

#include <cdr/base/error.h>
#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <set>

namespace cdr::scene {

std::vector<GltfReference> gltfReferences(const std::filesystem::path& path, const GltfLimits& limits) {
    const gltf::ByteSource file(std::make_shared<const gltf::OpenFile>(path, limits.maxFileBytes, ""));
    std::vector<GltfReference> references;
    std::set<std::string> known;
    const gltf::Files files(path.parent_path(), limits);
    const auto attempt = [](const auto& read) {
        try {
            read();
        } catch (const base::InputError&) { // loadGltf() says what is wrong, if it uses it
        }
    };
    attempt([&] {
        const nlohmann::json root = gltf::parseBoundedJson(gltf::openContainer(file).text());
        for (const char* key : {"buffers", "images"}) {
            for (const nlohmann::json& item : gltf::arrayMember(root, key)) {
                attempt([&] {
                    const std::string uri = gltf::stringMember(item, "uri").value_or("data:");
                    if (!gltf::isDataUri(uri) && known.insert(uri).second) {
                        references.push_back({.uri = uri, .path = files.resolve(uri)});
                    }
                });
            }
        }
    });
    return references;
}

} // namespace cdr::scene
