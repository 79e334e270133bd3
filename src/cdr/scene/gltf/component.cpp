#include "component.h"

#include "checks.h"

#include <algorithm>
#include <array>
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
    case kByte:
    case kUnsignedByte:
        return 1;
    case kShort:
    case kUnsignedShort:
        return 2;
    case kInt:
    case kUnsignedInt:
    case kFloat:
        return 4;
    case kDouble:
        return 8;
    default:
        refuse("component type {} does not exist", type);
    }
}

int componentsOf(std::string_view type, const std::string& where) {
    constexpr std::array<std::string_view, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    const auto found = std::find(kTypes.begin(), kTypes.end(), type);
    if (found != kTypes.end()) {
        return static_cast<int>(found - kTypes.begin()) + 1;
    }
    if (type == "MAT4") {
        return 16;
    }
    if (type != "MAT2" && type != "MAT3") {
        refuse("{}: its type '{}' does not exist", where, oneLine(type));
    }
    return 0;
}

double component(const std::uint8_t* bytes, const ComponentForm& form) {
    const auto scaled = [&form](double value, double largest) {
        return form.normalized ? std::max(value / largest, -1.0) : value;
    };
    switch (form.type) {
    case kByte:
        return scaled(load<std::int8_t>(bytes), 127.0);
    case kUnsignedByte:
        return scaled(load<std::uint8_t>(bytes), 255.0);
    case kShort:
        return scaled(load<std::int16_t>(bytes), 32767.0);
    case kUnsignedShort:
        return scaled(load<std::uint16_t>(bytes), 65535.0);
    case kInt:
        return scaled(load<std::int32_t>(bytes), 2147483647.0);
    case kUnsignedInt:
        return scaled(load<std::uint32_t>(bytes), 4294967295.0);
    case kDouble:
        return load<double>(bytes);
    default:
        return static_cast<double>(load<float>(bytes));
    }
}

std::uint32_t unsignedAt(const std::uint8_t* bytes, int type) {
    switch (type) {
    case kUnsignedByte:
        return load<std::uint8_t>(bytes);
    case kUnsignedShort:
        return load<std::uint16_t>(bytes);
    default:
        return load<std::uint32_t>(bytes);
    }
}

bool isIndexType(int type) {
    return type == kUnsignedByte || type == kUnsignedShort || type == kUnsignedInt;
}

} // namespace cdr::scene::gltf
