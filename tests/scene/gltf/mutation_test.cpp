#include "fixture.h"

#include <cdr/image/codec.h>
#include <cdr/platform/base64.h>
#include <cdr/platform/file.h>
#include <cdr/scene/gltf/import.h>

#include <functional>
#include <random>
#include <string_view>

namespace cdr::scene::test {
namespace {

/// A document that reaches most of the importer: texture, sparse accessor, strip, transform, several nodes.
Document everything() {
    Document document = square();
    json& primitive = document.primitive();
    document.setFloats("TEXCOORD_0", "VEC2", {0, 0, 1, 0, 1, 1, 0, 1});
    primitive["attributes"]["COLOR_0"] =
        document.addAccessor(std::vector<std::uint8_t>(16, 200), "VEC4", kUByte);
    document.root["accessors"].back()["normalized"] = true;
    primitive["material"] = 0;
    document.root["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint16_t>{1, 2})}, {"componentType", kUShort}}},
        {"values", {{"bufferView", document.addView(std::vector<float>{8, 0, 0, 8, 4, 0})}}}};
    json strip = primitive;
    strip["mode"] = kStrip;
    strip["attributes"].erase("NORMAL");
    document.root["meshes"].push_back({{"name", "strip"}, {"primitives", {strip}}});
    document.root["nodes"] = {{{"mesh", 0}, {"translation", {1, 2, 3}}, {"children", {1, 2}}},
                              {{"mesh", 1}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {-1, 2, 0.5}}},
                              {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}}};
    const image::ImageRgba8 picture(4, 4, {10, 20, 30, 255});
    document.root["images"] = {{{"bufferView", document.addView(image::encodePng(picture))}},
                               {{"bufferView", document.addView(image::encodePng(picture))}}};
    document.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 10497}}};
    document.root["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
    document.root["materials"] = {
        {{"alphaMode", "BLEND"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 1, 1, 0.5}},
           {"metallicFactor", 0.5},
           {"roughnessFactor", 0.25},
           {"metallicRoughnessTexture", {{"index", 1}}},
           {"baseColorTexture",
            {{"index", 0},
             {"extensions", {{"KHR_texture_transform", {{"offset", {0, 1}}, {"scale", {1, -1}}}}}}}}}}}};
    return document;
}

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) {
    return limit == 0 ? 0 : random() % limit;
}

void flipBytes(Bytes& file, Random& random) {
    // Half of them in the last third, where the buffer is: its damage does not end at the JSON parser.
    const std::size_t first = random() % 2 == 0 ? 0 : file.size() / 3 * 2;
    for (std::size_t n = 1 + below(random, 4); n > 0; --n) {
        file[first + below(random, file.size() - first)] ^= static_cast<std::uint8_t>(1u << below(random, 8));
    }
}

void truncate(Bytes& file, Random& random) {
    file.resize(below(random, file.size()));
}

/// Puts another number where the text has one; the length stays, so that the GLB's chunks do.
void replaceNumber(Bytes& file, Random& random) {
    static constexpr std::string_view kNumbers[] = {
        "-1",    "0",      "1",          "4294967295", "2147483647", "4294967296", "1e308",
        "-1e99", "0.5",    "99999999",   "null",       "[]",         "{}",         "65536",
        "\"\"",  "1e-300", "2147483648", "255",        "-0",         "5126"};
    const std::size_t start = below(random, file.size());
    for (std::size_t i = 0; i < file.size(); ++i) {
        const std::size_t at = (start + i) % file.size();
        const auto isDigit = [&file](std::size_t p) {
            return p < file.size() && file[p] >= '0' && file[p] <= '9';
        };
        if (isDigit(at) && at > 0 && (file[at - 1] == ':' || file[at - 1] == ',' || file[at - 1] == '[')) {
            std::size_t end = at;
            while (isDigit(end)) {
                ++end;
            }
            const std::string_view number = kNumbers[below(random, std::size(kNumbers))];
            file.erase(file.begin() + static_cast<std::ptrdiff_t>(at),
                       file.begin() + static_cast<std::ptrdiff_t>(end));
            file.insert(file.begin() + static_cast<std::ptrdiff_t>(at), number.begin(), number.end());
            return;
        }
    }
}

/// Edits a length or type of the GLB's header or of a chunk.
void editChunk(Bytes& file, Random& random) {
    static constexpr std::uint8_t kBytes[] = {0, 1, 3, 4, 0x7f, 0x80, 0xff};
    const std::size_t jsonLength = file[12] + 256u * file[13] + 65536u * file[14];
    const std::size_t headers[] = {4, 8, 12, 16, 20 + jsonLength, 24 + jsonLength};
    const std::size_t at = headers[below(random, std::size(headers))] + below(random, 4);
    if (at < file.size()) {
        file[at] = kBytes[below(random, std::size(kBytes))];
    }
}

void duplicateRange(Bytes& file, Random& random) {
    const std::size_t from = below(random, file.size());
    const std::size_t size = below(random, std::min<std::size_t>(64, file.size() - from));
    const Bytes copy(file.begin() + static_cast<std::ptrdiff_t>(from),
                     file.begin() + static_cast<std::ptrdiff_t>(from + size));
    file.insert(file.begin() + static_cast<std::ptrdiff_t>(below(random, file.size())), copy.begin(),
                copy.end());
}

/// Loads, or refuses in one line that starts with the file's name; anything else fails the test.
bool loads(const Bytes& file) {
    GltfLimits limits;
    limits.maxTriangles = 10'000;
    limits.maxBytes = 64u << 20;
    limits.maxFileBytes = 1u << 20;
    try {
        for (const Material& material :
             gltf::importGltf(gltf::ByteSource(file), "/nowhere/a.glb", limits).scene.materials) {
            const MetallicRoughness metallicRoughness =
                material.metallicRoughness.value_or(MetallicRoughness{});
            EXPECT_TRUE(metallicRoughness.metallic >= 0.0f && metallicRoughness.metallic <= 1.0f)
                << metallicRoughness.metallic;
            EXPECT_TRUE(metallicRoughness.roughness >= 0.0f && metallicRoughness.roughness <= 1.0f)
                << metallicRoughness.roughness;
        }
        return true;
    } catch (const base::InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("/nowhere/a.glb: ")) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), 500u) << message;
        return false;
    }
}

TEST(GltfMutation, LoadsOrRefusesAndNothingElse) {
    const Document document = everything();
    Document text = document;
    text.root["buffers"] = {
        {{"byteLength", document.bin.size()},
         {"uri", "data:application/octet-stream;base64," + platform::toBase64(document.bin)}}};
    const std::string json = text.root.dump();
    const std::vector<Bytes> seeds{document.glb(), Bytes(json.begin(), json.end())};
    for (const Bytes& seed : seeds) {
        ASSERT_TRUE(loads(seed)) << "the seed must be sound, else nothing behind its fault is reached";
    }
    const std::function<void(Bytes&, Random&)> mutations[] = {
        flipBytes, flipBytes, replaceNumber, replaceNumber, truncate, duplicateRange, editChunk};
    Random random(20130521);
    int loaded = 0;
    constexpr int kRounds = 20'000;
    for (int round = 0; round < kRounds; ++round) {
        Bytes file = seeds[round % 8 == 0 ? 1 : 0];
        for (std::size_t n = 1 + below(random, 2); n > 0 && file.size() > 32; --n) {
            mutations[below(random, std::size(mutations))](file, random);
        }
        loaded += loads(file) ? 1 : 0;
    }
    // Both ways out must be taken often, else the mutations miss the importer.
    EXPECT_GT(loaded, kRounds / 50);
    EXPECT_LT(loaded, kRounds * 9 / 10);
}

TEST(GltfMutation, EveryNumberOfTheDocumentMayBeWrong) {
    const Document document = everything();
    const json flat = document.root.flatten();
    for (const auto& [pointer, value] : flat.items()) {
        for (const json& wrong : {json(-1), json(7), json(2147483647), json(4294967296), json(1e300),
                                  json("x"), json(nullptr), json::array(), json::object(), json(true)}) {
            Document mutated = document;
            mutated.root[json::json_pointer(pointer)] = wrong;
            loads(mutated.glb());
        }
    }
}

} // namespace
} // namespace cdr::scene::test
