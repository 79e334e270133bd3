#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::scene::gltf {

/// glTF's numbers for component types.
enum ComponentType {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kInt = 5124,
    kUnsignedInt = 5125,
    kFloat = 5126,
    kDouble = 5130
};

/// Bytes of one component of glTF's numbered types; refuses a type that does not exist.
std::size_t componentBytes(int componentType);

/// Components of an element of glTF's types: 1 of SCALAR to 4 of VEC4, and 16 of MAT4. 0 of a smaller matrix, which nothing
/// that we read is. Refuses a type that does not exist.
int componentsOf(std::string_view type, const std::string& where);

/// How a component is stored.
struct ComponentForm {
    int type = 0;            ///< ComponentType
    bool normalized = false; ///< integers span [0, 1] or [-1, 1], as glTF defines it
};

/// A component as a number. The bytes may lie at any alignment.
double component(const std::uint8_t* bytes, const ComponentForm& form);

/// Whether a type can hold vertex indices.
bool isIndexType(int componentType);

/// An integer of a type that isIndexType().
std::uint32_t unsignedAt(const std::uint8_t* bytes, int componentType);

} // namespace cdr::scene::gltf
