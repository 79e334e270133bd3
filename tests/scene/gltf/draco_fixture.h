#pragma once

#include "fixture.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <map>
#include <memory>
#include <optional>

namespace cdr::scene::test {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// How a primitive is compressed.
struct DracoOptions {
    int method = draco::MESH_EDGEBREAKER_ENCODING;
    std::optional<int> submethod{};
    int speed = 3;
    int bits = 14; ///< of each component of floats; 0 keeps them as they are
    bool metadata = false;
};

/// How far a quantised number may be from its own, relative to the extent of all of them.
inline float dracoTolerance(const DracoOptions& options) {
    return options.bits == 0 ? 0.0f : 1.0f / static_cast<float>((1 << options.bits) - 1);
}

inline draco::DataType dracoType(int componentType) {
    const std::map<int, draco::DataType> types{{kByte, draco::DT_INT8},   {kUByte, draco::DT_UINT8},
                                               {kShort, draco::DT_INT16}, {kUShort, draco::DT_UINT16},
                                               {kUInt, draco::DT_UINT32}, {kFloat, draco::DT_FLOAT32}};
    return types.at(componentType);
}

inline draco::GeometryAttribute::Type dracoRole(const std::string& name) {
    using Role = draco::GeometryAttribute;
    const std::map<std::string, Role::Type> roles{
        {"POSITION", Role::POSITION}, {"NORMAL", Role::NORMAL}, {"COLOR_0", Role::COLOR}};
    const auto found = roles.find(name);
    return found != roles.end()            ? found->second
           : name.starts_with("TEXCOORD_") ? Role::TEX_COORD
                                           : Role::GENERIC;
}

/// The bytes of an accessor of a document, whose elements follow each other.
inline const std::uint8_t* bytesOf(const Document& document, const json& accessor) {
    const json& view = document.root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    return document.bin.data() + view["byteOffset"].get<std::size_t>();
}

/// A document's primitive as Draco has it; the unique ids of its attributes begin at `firstId`, in their order.
inline std::unique_ptr<draco::Mesh> dracoMesh(const Document& document, const json& primitive,
                                              std::uint32_t firstId) {
    auto mesh = std::make_unique<draco::Mesh>();
    const json& accessors = document.root["accessors"];
    const json& indices = accessors[primitive["indices"].get<std::size_t>()];
    const auto* list = reinterpret_cast<const std::uint16_t*>(bytesOf(document, indices));
    mesh->SetNumFaces(indices["count"].get<std::size_t>() / 3);
    for (std::uint32_t i = 0; i < mesh->num_faces(); ++i) {
        mesh->SetFace(draco::FaceIndex(i),
                      {draco::PointIndex(list[3 * i]), draco::PointIndex(list[3 * i + 1]),
                       draco::PointIndex(list[3 * i + 2])});
    }
    for (const auto& [name, index] : primitive["attributes"].items()) {
        const json& accessor = accessors[index.get<std::size_t>()];
        const std::string type = accessor["type"];
        const auto components = static_cast<std::uint8_t>(type == "SCALAR" ? 1 : type.back() - '0');
        const draco::DataType componentType = dracoType(accessor["componentType"]);
        const int stride = components * draco::DataTypeLength(componentType);
        draco::GeometryAttribute attribute;
        attribute.Init(dracoRole(name), nullptr, components, componentType,
                       accessor.value("normalized", false), stride, 0);
        const auto count = accessor["count"].get<std::uint32_t>();
        mesh->set_num_points(count);
        const int id = mesh->AddAttribute(attribute, true, count);
        for (std::uint32_t i = 0; i < count; ++i) {
            mesh->attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                                   bytesOf(document, accessor) +
                                                       i * static_cast<std::uint32_t>(stride));
        }
        mesh->attribute(id)->set_unique_id(firstId++);
    }
    return mesh;
}

/// What the library makes of a primitive.
struct DracoStreamMade {
    Bytes bytes;
    std::size_t vertices = 0;
};

inline DracoStreamMade dracoStream(draco::Mesh& mesh, const DracoOptions& options) {
    if (options.method == draco::MESH_EDGEBREAKER_ENCODING) {
        mesh.DeduplicateAttributeValues(); // so that it knows what touches
        mesh.DeduplicatePointIds();
    }
    if (options.metadata) {
        auto metadata = std::make_unique<draco::GeometryMetadata>();
        metadata->AddEntryString("tool", "a test");
        for (const char* name : {"inner", "other"}) {
            auto part = std::make_unique<draco::Metadata>();
            part->AddEntryInt("number", 3);
            part->AddSubMetadata("innermost", std::make_unique<draco::Metadata>());
            metadata->AddSubMetadata(name, std::move(part));
        }
        mesh.AddMetadata(std::move(metadata));
        auto ofAttribute = std::make_unique<draco::AttributeMetadata>();
        ofAttribute->AddEntryString("name", "positions");
        mesh.AddAttributeMetadata(0, std::move(ofAttribute));
    }
    draco::ExpertEncoder encoder(mesh);
    encoder.SetTrackEncodedProperties(true);
    encoder.SetEncodingMethod(options.method);
    if (options.submethod) {
        encoder.SetEncodingSubmethod(*options.submethod);
    }
    encoder.SetSpeedOptions(options.speed, options.speed);
    for (int i = 0; options.bits > 0 && i < mesh.num_attributes(); ++i) {
        if (mesh.attribute(i)->data_type() == draco::DT_FLOAT32) {
            encoder.SetAttributeQuantization(i, options.bits);
        }
    }
    draco::EncoderBuffer buffer;
    const draco::Status status = encoder.EncodeToBuffer(&buffer);
    EXPECT_TRUE(status.ok()) << status.error_msg_string();
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(buffer.data());
    return {Bytes(bytes, bytes + buffer.size()), encoder.num_encoded_points()};
}

/// Puts a primitive's compressed form into a document; nothing else of the primitive is left but morph targets.
inline void useDraco(Document& document, json& primitive, const DracoStreamMade& stream,
                     std::uint32_t firstId) {
    json ids = json::object();
    for (const auto& [name, index] : primitive["attributes"].items()) {
        json& accessor = document.root["accessors"][index.get<std::size_t>()];
        accessor.erase("bufferView");
        accessor["count"] = stream.vertices;
        ids[name] = firstId++;
    }
    document.root["accessors"][primitive["indices"].get<std::size_t>()].erase("bufferView");
    primitive["extensions"][kDraco] = {{"bufferView", document.addView(stream.bytes)}, {"attributes", ids}};
    document.root["extensionsUsed"] = {kDraco};
    document.root["extensionsRequired"] = {kDraco};
}

/// A document whose primitive is compressed.
inline Document compressed(Document document, const DracoOptions& options) {
    constexpr std::uint32_t kFirstId = 7; // no index, so that ids are not mistaken for one
    json primitive = document.primitive();
    const std::unique_ptr<draco::Mesh> mesh = dracoMesh(document, primitive, kFirstId);
    useDraco(document, primitive, dracoStream(*mesh, options), kFirstId);
    document.primitive() = primitive;
    return document;
}

} // namespace cdr::scene::test
