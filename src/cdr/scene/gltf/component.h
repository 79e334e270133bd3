#pragma once

#include <cstddef>
#include <cstdint>

namespace cdr::scene::gltf {

/// Bytes of one component of glTF's numbered types; refuses a type that does not exist.
std::size_t componentBytes(int componentType);

/// Components of an element of tinygltf's numbered types, 0 of a matrix: no attribute that we read is one.
int componentsOf(int type);

/// A component as a number; normalized integers span [0, 1] or [-1, 1] as glTF defines it. The bytes may lie
/// at any alignment.
double component(const std::uint8_t* bytes, int componentType, bool normalized);

/// Whether a type can hold vertex indices.
bool isIndexType(int componentType);

/// An integer of a type that isIndexType().
std::uint32_t unsignedAt(const std::uint8_t* bytes, int componentType);

} // namespace cdr::scene::gltf
