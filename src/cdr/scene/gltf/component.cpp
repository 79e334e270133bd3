#include "component.h"

#include "checks.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>

namespace cdr::scene::gltf {

namespace {

/// glTF buffers are little-endian and so is every device we run on; a buffer may hold them at any alignment.
template <typename Number>
Number load(const std::uint8_t* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof(number));
    return number;
}

} // namespace

std::size_t componentBytes(int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_INT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
        return 8;
    default:
        refuse("component type {} does not exist", type);
    }
}

int componentsOf(int type) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return 1;
    case TINYGLTF_TYPE_VEC2:
        return 2;
    case TINYGLTF_TYPE_VEC3:
        return 3;
    case TINYGLTF_TYPE_VEC4:
        return 4;
    default:
        return 0;
    }
}

double component(const std::uint8_t* bytes, int type, bool normalized) {
    const auto scaled = [normalized](double value, double largest) {
        return normalized ? std::max(value / largest, -1.0) : value;
    };
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return scaled(load<std::int8_t>(bytes), 127.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return scaled(load<std::uint8_t>(bytes), 255.0);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return scaled(load<std::int16_t>(bytes), 32767.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return scaled(load<std::uint16_t>(bytes), 65535.0);
    case TINYGLTF_COMPONENT_TYPE_INT:
        return scaled(load<std::int32_t>(bytes), 2147483647.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return scaled(load<std::uint32_t>(bytes), 4294967295.0);
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
        return load<double>(bytes);
    default:
        return static_cast<double>(load<float>(bytes));
    }
}

std::uint32_t unsignedAt(const std::uint8_t* bytes, int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    default:
        return load<std::uint32_t>(bytes);
    }
}

bool isIndexType(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

} // namespace cdr::scene::gltf
