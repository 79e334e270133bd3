#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::scene::gltf {

/// Parses JSON whose depth and number of values are bounded, so that no recursion over it can exhaust the
/// stack.
nlohmann::json parseBoundedJson(std::string_view text);

/// An integer in [0, 2^31), which glTF lets be written as a decimal: 4.0 is 4. Nothing for any other value.
std::optional<int> indexOf(const nlohmann::json& value);

// Each refuses a member that is of another type. `where` says which part of the file it is, for the message.

/// A member of an object, or null when it is absent or `value` is not an object.
const nlohmann::json* member(const nlohmann::json& value, const char* key);
/// An array member, an empty array when absent.
const nlohmann::json& arrayMember(const nlohmann::json& object, const char* key);
/// An object member, an empty object when absent.
const nlohmann::json& objectMember(const nlohmann::json& object, const char* key, const std::string& where);
/// A string member, nothing when absent.
std::optional<std::string> stringMember(const nlohmann::json& object, const char* key);
/// Whether a member is true; false when absent.
bool boolMember(const nlohmann::json& object, const char* key, const std::string& where);
/// A member that is a number, nothing when absent.
std::optional<double> numberMember(const nlohmann::json& object, const char* key, const std::string& where);
/// A member that is an array of `length` numbers, nothing when absent.
std::optional<std::vector<double>> numbersMember(const nlohmann::json& object, const char* key,
                                                 std::size_t length, const std::string& where);
/// A member that is an array of finite numbers, empty when absent.
std::vector<double> numbersOf(const nlohmann::json& object, const char* key, const std::string& where);
/// A member that is an index or a size: an integer in [0, 2^31). Nothing when absent.
std::optional<int> indexMember(const nlohmann::json& object, const char* key);
/// The same, and refuses an object that lacks it.
int requiredIndex(const nlohmann::json& object, const char* key, const std::string& where);
/// A member that is an array of indices, empty when absent.
std::vector<int> indicesMember(const nlohmann::json& object, const char* key);
/// The members of an object that are all indices, such as the attributes of a primitive.
std::map<std::string, int> indicesByName(const nlohmann::json& object);

/// The object of an extension, or null when the glTF object has none of this name.
const nlohmann::json* extensionOf(const nlohmann::json& object, const char* name);
/// The item that an index means in an array of the document, such as "nodes"; refuses an index without one.
/// `kind` says what the items are, in the singular.
const nlohmann::json& itemAt(const nlohmann::json& root, const char* key, int index, std::string_view kind);

/// The string `value`; refuses another type, naming the key it came from.
std::string requireString(const nlohmann::json& value, const char* key);
/// The whole name of a glTF object, a view into it; empty when it has none.
std::string_view fullNameOf(const nlohmann::json& object);
/// Its beginning as one line, for messages.
std::string nameOf(const nlohmann::json& object);

} // namespace cdr::scene::gltf
