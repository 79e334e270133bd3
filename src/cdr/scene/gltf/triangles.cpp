#include "triangles.h"

#include "checks.h"
#include "draco/decompressor.h"

namespace cdr::scene::gltf {

namespace {

/// Null where corners are the vertices in turn.
const Accessor* usableIndices(const Primitive& primitive, Accessors& accessors) {
    const Accessor* indices = indicesOf(primitive, accessors);
    if (indices != nullptr) {
        indices->requireIndices(primitive.indices);
    }
    return indices;
}

std::uint32_t vertexAt(const Accessor* indices, std::size_t corner, std::size_t vertexCount,
                       const std::string& where) {
    const std::uint32_t index =
        indices == nullptr ? static_cast<std::uint32_t>(corner) : indices->integer(corner);
    if (index >= vertexCount) {
        refuse("{}: index {} exceeds its {} vertices", where, index, vertexCount);
    }
    return index;
}

/// Which corner is corner `c` of triangle `t`; the formulas are glTF's, so fronts stay fronts.
std::size_t cornerOf(int mode, std::size_t t, std::size_t c) {
    if (mode == kModeTriangleStrip) {
        return t % 2 == 1 && c > 0 ? t + 3 - c : t + c;
    }
    if (mode == kModeTriangleFan) {
        return c == 2 ? 0 : t + 1 + c;
    }
    return 3 * t + c;
}

} // namespace

std::size_t cornerCount(const Primitive& primitive, Accessors& accessors) {
    const Accessor* indices = indicesOf(primitive, accessors);
    const Accessor* corners = indices != nullptr ? indices : attributeOf(primitive, "POSITION", accessors);
    return corners == nullptr ? 0 : corners->count();
}

std::vector<std::uint32_t> cornerList(const Primitive& primitive, Accessors& accessors,
                                      std::size_t vertexCount, const std::string& where) {
    const Accessor* indices = usableIndices(primitive, accessors);
    std::vector<std::uint32_t> list(cornerCount(primitive, accessors));
    for (std::size_t corner = 0; corner < list.size(); ++corner) {
        list[corner] = vertexAt(indices, corner, vertexCount, where);
    }
    return list;
}

std::uint64_t triangleCount(const Primitive& primitive, Accessors& accessors) {
    const std::size_t corners = cornerCount(primitive, accessors);
    switch (primitive.mode) {
    case kModeTriangles:
        return corners / 3;
    case kModeTriangleStrip:
    case kModeTriangleFan:
        return corners < 3 ? 0 : corners - 2;
    default:
        return 0;
    }
}

std::vector<std::uint32_t> triangleList(const Primitive& primitive, Accessors& accessors,
                                        std::size_t vertexCount, const std::string& where) {
    const Accessor* indices = usableIndices(primitive, accessors);
    const std::size_t triangles = triangleCount(primitive, accessors);
    std::vector<std::uint32_t> list;
    list.reserve(triangles * 3);
    for (std::size_t t = 0; t < triangles; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            list.push_back(vertexAt(indices, cornerOf(primitive.mode, t, c), vertexCount, where));
        }
    }
    return list;
}

} // namespace cdr::scene::gltf
