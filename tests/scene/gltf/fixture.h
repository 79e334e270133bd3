#pragma once

#include "../../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/scene/gltf/gltf.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cdr::scene::test {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

/// glTF's numbers for component types and primitive modes.
enum Type { kByte = 5120, kUByte = 5121, kShort = 5122, kUShort = 5123, kUInt = 5125, kFloat = 5126 };
enum Mode { kPoints = 0, kLines = 1, kLineLoop = 2, kLineStrip = 3, kTriangles = 4, kStrip = 5, kFan = 6 };

/// A glTF document under construction: its JSON and its one binary buffer.
struct Document {
    json root = {
        {"asset", {{"version", "2.0"}}}, {"accessors", json::array()}, {"bufferViews", json::array()}};
    Bytes bin;

    /// Appends bytes as a buffer view and returns its index.
    template <typename T>
    int addView(const std::vector<T>& data) {
        const std::size_t offset = bin.size();
        const std::size_t size = data.size() * sizeof(T);
        bin.resize(offset + (size + 3) / 4 * 4);
        std::copy_n(reinterpret_cast<const Bytes::value_type*>(data.data()), size,
                    bin.begin() + static_cast<std::ptrdiff_t>(offset));
        root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        return static_cast<int>(root["bufferViews"].size()) - 1;
    }

    /// Appends an accessor of `data` and returns its index.
    template <typename T>
    int addAccessor(const std::vector<T>& data, const std::string& type, int componentType) {
        const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
        root["accessors"].push_back({{"bufferView", addView(data)},
                                     {"componentType", componentType},
                                     {"count", data.size() / components},
                                     {"type", type}});
        return static_cast<int>(root["accessors"].size()) - 1;
    }

    json& primitive(std::size_t mesh = 0, std::size_t i = 0) { return root["meshes"][mesh]["primitives"][i]; }

    /// Gives the first primitive an attribute of float32.
    void setFloats(const std::string& attribute, const std::string& type, const std::vector<float>& data) {
        primitive()["attributes"][attribute] = addAccessor(data, type, kFloat);
    }

    /// The bytes of a GLB file.
    Bytes glb() const {
        json complete = root;
        if (!bin.empty() && !complete.contains("buffers")) {
            complete["buffers"] = {{{"byteLength", bin.size()}}};
        }
        std::string text = complete.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        Bytes file;
        const auto add32 = [&file](std::size_t value) {
            for (int shift = 0; shift < 32; shift += 8) {
                file.push_back(static_cast<std::uint8_t>(value >> shift));
            }
        };
        add32(0x46546c67);
        add32(2);
        add32(12 + 8 + text.size() + (bin.empty() ? 0 : 8 + bin.size()));
        add32(text.size());
        add32(0x4e4f534a);
        file.insert(file.end(), text.begin(), text.end());
        if (!bin.empty()) {
            add32(bin.size());
            add32(0x004e4942);
            file.insert(file.end(), bin.begin(), bin.end());
        }
        return file;
    }
};

/// Three corners of the square (0, 0, 0) (2, 0, 0) (2, 4, 0) (0, 4, 0), and with `square` all four.
inline std::vector<float> corners(bool square) {
    std::vector<float> positions{0, 0, 0, 2, 0, 0, 2, 4, 0};
    if (square) {
        positions.insert(positions.end(), {0, 4, 0});
    }
    return positions;
}

/// One node with one mesh of one triangle, without normals.
inline Document triangle() {
    Document document;
    const int position = document.addAccessor(corners(false), "VEC3", kFloat);
    document.root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}}};
    document.root["nodes"] = {{{"mesh", 0}}};
    document.root["scenes"] = {{{"nodes", {0}}}};
    document.root["scene"] = 0;
    return document;
}

/// The square of corners(true) as two indexed triangles with normals.
inline Document square() {
    Document document = triangle();
    document.root["accessors"].clear();
    document.setFloats("POSITION", "VEC3", corners(true));
    document.setFloats("NORMAL", "VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    document.primitive()["indices"] =
        document.addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUShort);
    return document;
}

/// Gives the first primitive a material with a flat normal texture.
inline void giveNormalTexture(Document& document) {
    const image::ImageRgba8 flat(1, 1, {128, 128, 255, 255});
    document.root["images"] = {
        {{"bufferView", document.addView(image::encodePng(flat))}, {"mimeType", "image/png"}}};
    document.root["textures"] = {{{"source", 0}}};
    document.root["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    document.primitive()["material"] = 0;
}

/// Has node 0 follow nodes 1 and 2, by the joints and an accessor of weights of the first primitive.
inline void giveSkin(Document& document, const std::vector<std::uint8_t>& joints, int weights,
                     const json& nodes) {
    json& attributes = document.primitive()["attributes"];
    attributes["JOINTS_0"] = document.addAccessor(joints, "VEC4", kUByte);
    attributes["WEIGHTS_0"] = weights;
    document.root["nodes"] = nodes;
    document.root["skins"] = {{{"joints", {1, 2}}}};
    document.root["scenes"][0]["nodes"] = {0, 1, 2};
}

/// An animation that moves a node: its place, three numbers, at each of the times.
inline void giveMove(Document& document, int node, const std::vector<float>& times,
                     const std::vector<float>& places) {
    const int input = document.addAccessor(times, "SCALAR", kFloat);
    const int output = document.addAccessor(places, "VEC3", kFloat);
    document.root["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}}};
}

/// Expects that `message` says `what` somewhere.
inline void expectSays(const std::string& message, const std::string& what) {
    EXPECT_NE(message.find(what), std::string::npos) << "'" << message << "' does not say '" << what << "'";
}

/// Gives each test a folder of its own, removed afterwards.
class GltfFolder : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder()); }

    /// Where assets go; its parent is of this test too, so that a test can plant a file outside.
    std::filesystem::path folder() const { return m_folder.path() / "asset"; }

    std::filesystem::path write(const std::string& name, const Bytes& bytes) const {
        const std::filesystem::path path = folder() / name;
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path;
    }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return write(name, Bytes(text.begin(), text.end()));
    }

    GltfImport load(const Document& document, const GltfLimits& limits = {}) const {
        return loadGltf(write("a.glb", document.glb()), limits);
    }

    /// The message that a file is refused with, after its name; "loaded" when it is not.
    static std::string refusal(const std::filesystem::path& path, const GltfLimits& limits = {}) {
        try {
            loadGltf(path, limits);
        } catch (const base::InputError& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            return message.substr(std::min(message.size(), path.string().size() + 2));
        }
        return "loaded";
    }
    std::string refusal(const Document& document, const GltfLimits& limits = {}) const {
        return refusal(write("a.glb", document.glb()), limits);
    }
    /// Expects that a document is refused once it has the value at that JSON pointer.
    void expectRefused(Document document, const char* pointer, const json& value,
                       const std::string& what) const {
        document.root[json::json_pointer(pointer)] = value;
        expectSays(refusal(document), what);
    }

  private:
    cdr::test::TemporaryFolder m_folder;
};

/// Whether one of the lines says `what`.
inline bool anySays(const std::vector<std::string>& lines, const std::string& what) {
    return std::any_of(lines.begin(), lines.end(),
                       [&what](const std::string& line) { return line.find(what) != std::string::npos; });
}

} // namespace cdr::scene::test
