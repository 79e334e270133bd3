// The one place where tinygltf is compiled: without file access, which the importer does itself.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE

// tinygltf needs these before it, <fstream> even when told to do without files.
// clang-format off
#include <fstream>
#include <nlohmann/json.hpp>
// clang-format on

#include "tinygltf.h"

#include "checks.h"

#include <tiny_gltf.h>

#include <limits>

namespace cdr::scene::gltf {

tinygltf::Model parseModel(const std::string& json) {
    if (json.size() > std::numeric_limits<unsigned int>::max()) {
        refuse("{} bytes of JSON are too many", json.size());
    }
    tinygltf::TinyGLTF parser;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    bool parsed = false;
    try {
        parsed = parser.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                            static_cast<unsigned int>(json.size()), "");
    } catch (const nlohmann::json::exception& badType) {
        error = badType.what();
    }
    if (!parsed || !error.empty()) {
        refuse("not sound glTF: {}", oneLine(error));
    }
    return model;
}

std::optional<std::vector<unsigned char>> decodeDataUri(const std::string& uri) {
    std::vector<unsigned char> bytes;
    std::string mediaType;
    if (!tinygltf::DecodeDataURI(&bytes, mediaType, uri, 0, false)) {
        return {};
    }
    return bytes;
}

} // namespace cdr::scene::gltf
