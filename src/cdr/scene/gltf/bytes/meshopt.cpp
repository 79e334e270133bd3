#include "meshopt.h"

#include "../checks.h"
#include "../json.h"

#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;
using MeshoptFilter = MeshoptView::Filter;
using Mode = MeshoptView::Mode;

constexpr std::size_t kMaxVertexBytes = 256;

// In the order of their enumerations.
constexpr std::array<std::string_view, 3> kModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::array<std::string_view, 4> kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};

template <typename Enum, std::size_t Count>
Enum named(const std::array<std::string_view, Count>& names, const std::string& name,
           const std::string& where) {
    if (const auto value = valueOf<Enum>(names, name)) {
        return *value;
    }
    refuse("{}: {} has no '{}'", where, kMeshopt, oneLine(name, kMaxNameLength));
}

bool isStrideRight(const MeshoptView& view) {
    if (view.mode != Mode::attributes) {
        return view.stride == 2 || view.stride == 4;
    }
    switch (view.filter) {
    case MeshoptFilter::octahedral:
        return view.stride == 4 || view.stride == 8;
    case MeshoptFilter::quaternion:
        return view.stride == 8;
    default:
        return view.stride > 0 && view.stride % 4 == 0 && view.stride <= kMaxVertexBytes;
    }
}

void unfilter(const MeshoptView& view, platform::Bytes& bytes) {
    switch (view.filter) {
    case MeshoptFilter::none:
        break;
    case MeshoptFilter::octahedral:
        meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
        break;
    case MeshoptFilter::quaternion:
        meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
        break;
    case MeshoptFilter::exponential:
        meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
        break;
    }
}

} // namespace

MeshoptView readMeshoptView(const json& extension, std::size_t bytes, const std::string& where) {
    const auto number = [&](const char* key) {
        return static_cast<std::size_t>(requiredIndex(extension, key, where));
    };
    const MeshoptView view{
        .buffer = requiredIndex(extension, "buffer", where),
        .offset = static_cast<std::size_t>(indexMember(extension, "byteOffset").value_or(0)),
        .length = number("byteLength"),
        .stride = number("byteStride"),
        .count = number("count"),
        .mode = named<Mode>(kModes, stringMember(extension, "mode").value_or(""), where),
        .filter = named<MeshoptFilter>(kFilters, stringMember(extension, "filter").value_or("NONE"), where)};
    if (!isStrideRight(view) || (view.mode != Mode::attributes && view.filter != MeshoptFilter::none)) {
        refuse("{}: {} has no elements of {} bytes in that mode and filter", where, kMeshopt, view.stride);
    }
    if (view.mode == Mode::triangles && view.count % 3 != 0) {
        refuse("{}: {} has {} indices, which make no triangles", where, kMeshopt, view.count);
    }
    if (view.count * view.stride != bytes) { // both below 2^31
        refuse("{}: {} has {} elements of {} bytes for {}", where, kMeshopt, view.count, view.stride, bytes);
    }
    return view;
}

platform::Bytes decodeMeshopt(const MeshoptView& view, std::span<const std::uint8_t> compressed,
                              const std::string& where) {
    platform::Bytes bytes(view.count * view.stride);
    using Decode = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
    const Decode decode = view.mode == Mode::attributes  ? Decode{meshopt_decodeVertexBuffer}
                          : view.mode == Mode::triangles ? Decode{meshopt_decodeIndexBuffer}
                                                         : Decode{meshopt_decodeIndexSequence};
    const int result = decode(bytes.data(), view.count, view.stride, compressed.data(), compressed.size());
    if (result != 0) {
        refuse("{}: what {} compressed is damaged, or of a later version", where, kMeshopt);
    }
    unfilter(view, bytes);
    return bytes;
}

} // namespace cdr::scene::gltf
