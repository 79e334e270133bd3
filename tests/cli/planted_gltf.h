#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cdr::cli_test {

/// A square that faces +z, and as a node of a file where and how large it is.
struct PlantedSquare {
    std::string name;
    glm::dvec3 place{0.0};
    double side = 1.0;
    nlohmann::json material{}; ///< null: none of its own
};

/// Writes a glTF file, with its bytes in a file beside it. It has squares, and a camera at the origin that looks along -z. All
/// are turned by 0.3 radians about y.
inline void writeSquares(const std::filesystem::path& file, const std::vector<PlantedSquare>& squares) {
    const std::vector<float> corners{-0.5f, -0.5f, 0.0f, 0.5f,  -0.5f, 0.0f,
                                     0.5f,  0.5f,  0.0f, -0.5f, 0.5f,  0.0f};
    const std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};
    std::filesystem::path bytes = file;
    bytes.replace_extension(".bin");
    std::ofstream out(bytes, std::ios::binary);
    out.write(reinterpret_cast<const char*>(corners.data()), 48);
    out.write(reinterpret_cast<const char*>(indices.data()), 12);

    const double half = 0.15;
    const nlohmann::json turn{0.0, std::sin(half), 0.0, std::cos(half)};
    nlohmann::json nodes = nlohmann::json::array();
    nlohmann::json children = nlohmann::json::array();
    const nlohmann::json primitive{{"attributes", {{"POSITION", 0}}}, {"indices", 1}};
    const nlohmann::json plain{{"primitives", nlohmann::json::array({primitive})}};
    nlohmann::json meshes = nlohmann::json::array({plain});
    nlohmann::json materials = nlohmann::json::array();
    for (const PlantedSquare& square : squares) {
        children.push_back(nodes.size());
        nodes.push_back({{"name", square.name},
                         {"mesh", square.material.is_null() ? 0 : meshes.size()},
                         {"translation", {square.place.x, square.place.y, square.place.z}},
                         {"scale", {square.side, square.side, 1.0}}});
        if (!square.material.is_null()) {
            meshes.push_back(plain);
            meshes.back()["primitives"][0]["material"] = materials.size();
            materials.push_back(square.material);
        }
    }
    children.push_back(nodes.size());
    nodes.push_back({{"name", "camera"}, {"camera", 0}});
    const std::size_t root = nodes.size();
    nodes.push_back({{"name", "root"}, {"rotation", turn}, {"children", children}});
    nlohmann::json document{
        {"asset", {{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {root}}}}},
        {"nodes", nodes},
        {"cameras",
         {{{"type", "perspective"},
           {"perspective", {{"yfov", 0.6}, {"znear", 0.1}, {"zfar", 10000.0}, {"aspectRatio", 1.7777778}}}}}},
        {"meshes", meshes},
        {"accessors",
         {{{"bufferView", 0},
           {"componentType", 5126},
           {"count", 4},
           {"type", "VEC3"},
           {"min", {-0.5, -0.5, 0.0}},
           {"max", {0.5, 0.5, 0.0}}},
          {{"bufferView", 1}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}}},
        {"bufferViews",
         {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 48}},
          {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 12}}}},
        {"buffers", {{{"uri", bytes.filename().string()}, {"byteLength", 60}}}}};
    if (!materials.empty()) {
        document["materials"] = materials;
    }
    std::ofstream(file) << document;
}

} // namespace cdr::cli_test
