#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/platform/file.h>
#include <cdr/scene/gltf/open_gltf.h>

namespace cdr::scene::test {
namespace {

namespace fs = std::filesystem;
using Gltf = GltfFolder;

/// The square with its buffer at `uri`.
std::string withBufferUri(const std::string& uri) {
    Document document = square();
    document.root["buffers"] = {{{"byteLength", document.bin.size()}, {"uri", uri}}};
    return document.root.dump();
}

TEST_F(Gltf, BuffersBesideTheFile) {
    write("data.bin", square().bin);
    fs::create_directories(folder() / "sub dir");
    write("sub dir/data+1.bin", square().bin);
    for (const char* uri :
         {"data.bin", "./data.bin", "sub%20dir/data+1.bin", "sub dir/../data.bin", "%64ata.bin"}) {
        EXPECT_EQ(refusal(write("a.gltf", withBufferUri(uri))), "loaded") << uri;
    }
    // The same, given by a path without a folder.
    const fs::path before = fs::current_path();
    fs::current_path(folder());
    EXPECT_EQ(loadGltf("a.gltf").scene.instances.size(), 1u);
    fs::current_path(before);
}

/// A file may be named with line breaks and with what terminals obey.
TEST_F(Gltf, AnErrorIsOneLineWhateverTheFileIsCalled) {
    const auto lineOf = [](const fs::path& path, const GltfChoice& choice) {
        return cdr::test::inputErrorOf([&] { openGltf(path, choice); }, "opened");
    };
    const std::string name = "bad\x1b[31m\n\u009b31m.gltf";
    const std::string shown = (folder() / "bad [31m   31m.gltf: ").string();
    expectSays(lineOf(folder() / name, {}), shown + "no such file");
    expectSays(lineOf(write(name, std::string("{")), {}), shown + "not valid JSON");
    write(name, square().glb());
    GltfChoice camera;
    camera.camera = 1;
    GltfChoice animation;
    animation.animation = "1";
    GltfChoice light;
    light.light = ModelLight::file;
    for (const GltfChoice& choice : {camera, animation, light}) {
        expectSays(lineOf(folder() / name, choice), shown);
    }
}

/// Those that are missing too, which another rank may have; not those that loadGltf() may not read.
TEST_F(Gltf, NamesTheFilesThatItRefersTo) {
    Document document = square();
    document.root["buffers"] = json::array({{{"uri", "data.bin"}},
                                            {{"uri", "data:application/octet-stream;base64,AAAA"}},
                                            {{"byteLength", 4}},
                                            {{"uri", "../secret.bin"}},
                                            {{"uri", 3}}});
    document.root["images"] = json::array(
        {{{"uri", "sub%20dir/a.png"}}, {{"uri", "data.bin"}}, {{"bufferView", 0}}, {{"uri", "b.png"}}});
    write("b.png", Bytes{1});
    const auto expectNames = [&](const std::vector<GltfReference>& references) {
        ASSERT_EQ(references.size(), 3u);
        const fs::path home = fs::canonical(folder());
        EXPECT_EQ(references[0].uri, "data.bin");
        EXPECT_EQ(references[0].path, home / "data.bin");
        EXPECT_EQ(references[1].uri, "sub%20dir/a.png");
        EXPECT_EQ(references[1].path, home / "sub dir/a.png");
        EXPECT_EQ(references[2].path, home / "b.png");
    };
    expectNames(gltfReferences(write("a.gltf", document.root.dump())));
    expectNames(gltfReferences(write("a.glb", document.glb())));
    EXPECT_TRUE(gltfReferences(write("a.gltf", std::string("{\"buffers\": 3}"))).empty());
    EXPECT_TRUE(gltfReferences(write("a.gltf", std::string("{"))).empty());
    EXPECT_TRUE(gltfReferences(write("a.glb", Bytes{0x67, 0x6c, 0x54, 0x46})).empty());
    EXPECT_THROW(gltfReferences(folder() / "none.gltf"), base::InputError);
}

TEST_F(Gltf, BuffersAsDataUri) {
    Document document = triangle();
    // 36 bytes: (0, 0, 0) (1, 0, 0) (0, 1, 0)
    const std::string floats = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    document.root["buffers"] = {
        {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + floats}}};
    EXPECT_EQ(refusal(write("a.gltf", document.root.dump())), "loaded");
    document.root["buffers"][0]["byteLength"] = 37;
    expectSays(refusal(write("a.gltf", document.root.dump())), "says it has 37 bytes but its data has 36");
    document.root["buffers"][0]["uri"] = "data:audio/wav;base64," + floats;
    expectSays(refusal(write("a.gltf", document.root.dump())), "data URI 'data:audio/wav;base64,");
}

TEST_F(Gltf, FilesOutsideTheFolderAreRefused) {
    const Bytes bin = square().bin;
    write("../secret.bin", bin);
    write("data.bin", bin);
    fs::create_symlink(folder() / "../secret.bin", folder() / "link.bin");
    fs::create_directory_symlink(folder() / "..", folder() / "up");
    fs::create_symlink(folder() / "data.bin", folder() / "inside.bin");
    const auto tryUri = [&](const std::string& uri) { return refusal(write("a.gltf", withBufferUri(uri))); };
    for (const char* uri : {"../secret.bin", "%2e%2e/secret.bin", "..%2fsecret.bin", "x/../../secret.bin",
                            "..", "./../secret.bin", "%2E%2E%2Fsecret.bin"}) {
        expectSays(tryUri(uri), "leads out of the file's folder");
    }
    expectSays(tryUri((folder() / "data.bin").string()), "leads out of the file's folder");
    expectSays(tryUri("%2fetc%2fpasswd"), "leads out of the file's folder");
    expectSays(tryUri("//host/data.bin"), "leads out of the file's folder");
    for (const char* uri : {"link.bin", "up/secret.bin"}) {
        expectSays(tryUri(uri), "through a link");
    }
    for (const char* uri : {"http://host/data.bin", "file:///etc/passwd", "C:/data.bin",
                            "file%3a///etc/passwd", "..\\secret.bin", "data%00.bin", ""}) {
        expectSays(tryUri(uri), "is not a relative path");
    }
    for (const char* uri : {"data%2", "data%zz.bin", "%"}) {
        expectSays(tryUri(uri), "hexadecimal");
    }
    EXPECT_EQ(tryUri("inside.bin"), "loaded");
}

TEST_F(Gltf, FilesThatCannotBeReadAreRefused) {
    const auto tryUri = [&](const std::string& uri) { return refusal(write("a.gltf", withBufferUri(uri))); };
    expectSays(tryUri("missing.bin"), "no such file");
    fs::create_directories(folder() / "folder.bin");
    expectSays(tryUri("folder.bin"), "not a regular file");
    for (const char* uri : {".", "./", "folder.bin/.."}) {
        expectSays(tryUri(uri), "names the file's folder, not a file in it");
    }
    write("short.bin", Bytes(10));
    expectSays(tryUri("short.bin"), "its data has 10");
    EXPECT_NE(tryUri(std::string(5000, 'x')), "loaded");
    expectSays(refusal(folder() / "missing.glb"), "no such file");
    expectSays(refusal(folder()), "not a regular file");
    expectSays(refusal(write("a.gltf", withBufferUri("a\nb\x01.bin"))), "a b .bin");
}

TEST_F(Gltf, ABufferThatNothingUsesMayBeMissing) {
    Document document = square();
    document.root["buffers"] = {{{"byteLength", document.bin.size()}},
                                {{"byteLength", 4}, {"uri", "missing.bin"}}};
    EXPECT_EQ(refusal(document), "loaded");
    document.root["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 4}});
    EXPECT_EQ(refusal(document), "loaded");
    document.root["accessors"][0]["bufferView"] = 4;
    expectSays(refusal(document), "missing.bin: no such file");
}

TEST_F(Gltf, OneFileNamedOftenDoesNotFillMemory) {
    Document document = square();
    write("data.bin", document.bin);
    for (int i = 0; i < 20; ++i) {
        document.root["buffers"].push_back({{"byteLength", document.bin.size()}, {"uri", "data.bin"}});
    }
    GltfLimits limits;
    limits.maxFileBytes = 4096;
    const fs::path path = write("a.gltf", document.root.dump());
    ASSERT_LT(fs::file_size(path), 4096u);
    EXPECT_EQ(refusal(path, limits), "loaded");
    document = triangle();
    document.root["bufferViews"].clear();
    json& primitives = document.root["meshes"][0]["primitives"];
    const json primitive = primitives[0];
    for (std::size_t i = 0; i < 5; ++i) { // each buffer is used
        document.root["buffers"].push_back({{"byteLength", 36}, {"uri", "large.bin"}});
        document.root["bufferViews"].push_back({{"buffer", i}, {"byteLength", 36}});
        document.root["accessors"][i] = document.root["accessors"][0];
        document.root["accessors"][i]["bufferView"] = i;
        primitives[i] = primitive;
        primitives[i]["attributes"]["POSITION"] = i;
    }
    const std::string text = document.root.dump();
    write("large.bin", Bytes(text.size()));
    limits.maxFileBytes = text.size();
    expectSays(refusal(write("a.gltf", text), limits), "over the limit of 0");
}

TEST_F(Gltf, UnsoundContainersAreRefused) {
    const Bytes good = square().glb();
    const auto withByte = [&](std::size_t at, std::uint8_t value) {
        Bytes bytes = good;
        bytes[at] = value;
        return refusal(write("a.glb", bytes));
    };
    expectSays(withByte(4, 1), "GLB version 1");
    expectSays(withByte(10, 0xff), "GLB says it has");
    expectSays(withByte(8, 1), "GLB");
    expectSays(withByte(14, 0xff), "GLB chunk 0 is");
    expectSays(withByte(16, 'X'), "not JSON");
    expectSays(withByte(0, 'X'), "not valid JSON");
    for (std::size_t size = 0; size < good.size(); size += 3) {
        EXPECT_NE(
            refusal(write("a.glb", Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)))),
            "loaded")
            << size;
    }
}

TEST_F(Gltf, BinChunkIsCheckedToItsLastByte) {
    // The chunk's own header counts too: without it 8 bytes past the file would be read.
    Document document = square();
    Bytes bytes = document.glb();
    const std::size_t binLength = bytes.size() - document.bin.size() - 8;
    bytes[binLength] = static_cast<std::uint8_t>(bytes[binLength] + 4);
    expectSays(refusal(write("a.glb", bytes)), "GLB chunk 1 is");
    document.root["buffers"] = {{{"byteLength", document.bin.size() + 1}}};
    expectSays(refusal(document), "buffer 0 says it has");
}

TEST_F(Gltf, OtherChunksAreSkipped) {
    Bytes bytes = square().glb();
    bytes.insert(bytes.end(), {4, 0, 0, 0, 'A', 'B', 'C', 'D', 1, 2, 3, 4});
    bytes[8] = static_cast<std::uint8_t>(bytes.size() & 0xff);
    bytes[9] = static_cast<std::uint8_t>(bytes.size() >> 8);
    EXPECT_EQ(refusal(write("a.glb", bytes)), "loaded");
}

TEST_F(Gltf, WhatIsNotGltf2IsRefused) {
    const auto tryText = [&](const std::string& text) { return refusal(write("a.gltf", text)); };
    expectSays(tryText(""), "not valid JSON");
    expectSays(tryText("[]"), "not an object");
    expectSays(tryText("{}"), "not glTF 2.0");
    expectSays(tryText(R"({"asset": {"version": "1.0"}})"), "glTF version '1.0'");
    expectSays(tryText(R"({"asset": {"version": "2.0", "minVersion": "2.1"}})"), "at least '2.1'");
    expectSays(tryText(R"({"asset": {"version": 2}})"), "'version' is not a string");
    expectSays(tryText(R"({"asset": {"version": "2.0"}, "nodes": {}})"), "'nodes' is not an array");
    expectSays(tryText(R"({"asset": {"version": "2.0"}, "nodes": [1]})"), "not sound glTF");
    expectSays(tryText(R"({"asset": {"version": "2.0"}, "nodes": [{"name": "\ud800"}]})"), "not valid JSON");
    EXPECT_EQ(tryText(R"({"asset": {"version": "2.0"}})"), "loaded") << "an empty scene is sound";
    EXPECT_EQ(tryText("\xef\xbb\xbf"
                      R"({"asset": {"version": "2.0"}})"),
              "loaded")
        << "with a byte order mark";
}

TEST_F(Gltf, ExtensionsItRequiresAreNamed) {
    Document document = square();
    for (const char* name : {"KHR_meshopt_compression", "KHR_texture_basisu"}) {
        document.root["extensionsRequired"] = {"KHR_materials_unlit", name};
        expectSays(refusal(document),
                   "requires the extension " + std::string(name) + ", which is not supported");
    }
    document.root["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform",
                                           "KHR_mesh_quantization", "EXT_meshopt_compression",
                                           "KHR_draco_mesh_compression"};
    EXPECT_EQ(refusal(document), "loaded");
    document.root["extensionsRequired"] = {5};
    expectSays(refusal(document), "'extensionsRequired' is not a string");
    // Each primitive may look through them.
    document.root["extensionsRequired"] = std::vector<std::string>(65, "KHR_materials_unlit");
    expectSays(refusal(document), "65 extensionsRequired are over the limit of 64");
}

TEST_F(Gltf, DeepJsonDoesNotExhaustTheStack) {
    for (const std::size_t depth : {200u, 2'000'000u}) {
        const std::string text = R"({"asset": {"version": "2.0"}, "extras": )" + std::string(depth, '[') +
                                 std::string(depth, ']') + "}";
        expectSays(refusal(write("a.gltf", text)), "nested over");
    }
    // Brackets inside strings do not count, after an escaped quote neither.
    const std::string text = R"({"asset": {"version": "2.0"}, "extras": "\")" + std::string(500, '[') + "\"}";
    EXPECT_EQ(refusal(write("a.gltf", text)), "loaded");
}

} // namespace
} // namespace cdr::scene::test
