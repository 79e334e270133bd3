#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace cdr::scene::gltf {

/// Parses JSON whose depth and number of values are bounded, so that no recursion over it can exhaust the
/// stack.
nlohmann::json parseBoundedJson(std::string_view text);

/// A member of an object, or null when it is absent or `value` is not an object.
const nlohmann::json* member(const nlohmann::json& value, const char* key);
/// An array member of an object, an empty array when absent. Refuses a member of another type.
const nlohmann::json& arrayMember(const nlohmann::json& object, const char* key);
/// A string member, nothing when absent. Refuses a member of another type.
std::optional<std::string> stringMember(const nlohmann::json& object, const char* key);
/// A member that is an index or a size: an integer in [0, 2^31). Nothing when absent; refuses anything else.
std::optional<int> indexMember(const nlohmann::json& object, const char* key);
/// The string `value`; refuses another type, naming the key it came from.
std::string requireString(const nlohmann::json& value, const char* key);
/// The name of a glTF object for messages, empty when it has none.
std::string nameOf(const nlohmann::json& object);

/// Refuses a document in which an index, a size, a transform or a factor is not what the format says.
/// tinygltf ignores an optional value of the wrong type and cuts integers to 32 bits, which would show
/// another scene than the file's.
void requireSoundNumbers(const nlohmann::json& root);

} // namespace cdr::scene::gltf
