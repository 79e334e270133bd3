#include "json.h"

#include "checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxDepth = 128;
constexpr std::size_t kMaxValues = 32'000'000;
constexpr int kMaxIndex = std::numeric_limits<int>::max();

/// Counts brackets and commas outside strings. Wherever the text is valid JSON the counts are right, and
/// where it stops being valid the parser stops too.
void requireBounded(std::string_view text) {
    std::size_t depth = 0;
    std::size_t values = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;
            inString = c != '"';
            continue;
        }
        inString = c == '"';
        depth += c == '[' || c == '{' ? 1 : 0;
        depth -= (c == ']' || c == '}') && depth > 0 ? 1 : 0;
        values += c == '[' || c == '{' || c == ',' ? 1 : 0;
        if (depth > kMaxDepth || values > kMaxValues) {
            refuse("its JSON is nested over {} deep or has over {} values", kMaxDepth, kMaxValues);
        }
    }
}

int requireIndex(const json& value, std::string_view key) {
    if (const std::optional<int> index = indexOf(value)) {
        return *index;
    }
    refuse("'{}' is {}, not an integer from 0 to {}", oneLine(key), oneLine(value.dump()), kMaxIndex);
}

} // namespace

json parseBoundedJson(std::string_view text) {
    requireBounded(text);
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::exception& error) {
        refuse("not valid JSON: {}", oneLine(error.what()));
    }
}

std::optional<int> indexOf(const json& value) {
    const double number = value.is_number() ? value.get<double>() : -1.0;
    const bool isIndex = number >= 0.0 && number <= kMaxIndex && number == std::floor(number);
    return isIndex ? std::optional(static_cast<int>(number)) : std::nullopt;
}

const json* member(const json& value, const char* key) {
    const auto found = value.find(key);
    return found == value.end() ? nullptr : &*found;
}

const json& arrayMember(const json& object, const char* key) {
    static const json kEmpty = json::array();
    const json* value = member(object, key);
    if (value == nullptr) {
        return kEmpty;
    }
    if (!value->is_array()) {
        refuse("'{}' is not an array", key);
    }
    return *value;
}

const json& objectMember(const json& object, const char* key, const std::string& where) {
    static const json kEmpty = json::object();
    const json* value = member(object, key);
    if (value == nullptr) {
        return kEmpty;
    }
    if (!value->is_object()) {
        refuse("{}: '{}' is not an object", where, key);
    }
    return *value;
}

std::optional<std::string> stringMember(const json& object, const char* key) {
    const json* value = member(object, key);
    return value == nullptr ? std::nullopt : std::optional(requireString(*value, key));
}

bool boolMember(const json& object, const char* key, const std::string& where) {
    const json* value = member(object, key);
    if (value != nullptr && !value->is_boolean()) {
        refuse("{}: '{}' is neither true nor false", where, key);
    }
    return value != nullptr && value->get<bool>();
}

std::optional<double> numberMember(const json& object, const char* key, const std::string& where) {
    const json* value = member(object, key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_number()) {
        refuse("{}: '{}' is not a number", where, key);
    }
    return value->get<double>();
}

std::optional<std::vector<double>> numbersMember(const json& object, const char* key, std::size_t length,
                                                 const std::string& where) {
    const json* value = member(object, key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_array() || value->size() != length ||
        !std::all_of(value->begin(), value->end(), [](const json& element) { return element.is_number(); })) {
        refuse("{}: '{}' is not {} numbers", where, key, length);
    }
    return value->get<std::vector<double>>();
}

std::vector<double> numbersOf(const json& object, const char* key, const std::string& where) {
    const std::size_t length = arrayMember(object, key).size();
    std::vector<double> numbers =
        length == 0 ? std::vector<double>() : numbersMember(object, key, length, where).value();
    if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); })) {
        refuse("{}: '{}' holds a number that is not finite", where, key);
    }
    return numbers;
}

std::optional<int> indexMember(const json& object, const char* key) {
    const json* value = member(object, key);
    return value == nullptr ? std::nullopt : std::optional(requireIndex(*value, key));
}

int requiredIndex(const json& object, const char* key, const std::string& where) {
    const std::optional<int> index = indexMember(object, key);
    if (!index) {
        refuse("{}: has no '{}'", where, key);
    }
    return *index;
}

std::vector<int> indicesMember(const json& object, const char* key) {
    std::vector<int> indices;
    for (const json& element : arrayMember(object, key)) {
        indices.push_back(requireIndex(element, key));
    }
    return indices;
}

std::map<std::string, int> indicesByName(const json& object) {
    std::map<std::string, int> indices;
    for (const auto& [key, value] : object.items()) {
        indices.emplace(key, requireIndex(value, key));
    }
    return indices;
}

const json* extensionOf(const json& object, const char* name) {
    const json* extensions = member(object, "extensions");
    const json* extension = extensions == nullptr ? nullptr : member(*extensions, name);
    return extension != nullptr && extension->is_object() ? extension : nullptr;
}

const json& itemAt(const json& root, const char* key, int index, std::string_view kind) {
    const json& items = arrayMember(root, key);
    if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
        refuse("{} {} does not exist, the file has {}", kind, index, items.size());
    }
    const json& item = items[static_cast<std::size_t>(index)];
    if (!item.is_object()) {
        refuse("not sound glTF: {} {} is not an object", kind, index);
    }
    return item;
}

std::string requireString(const json& value, const char* key) {
    if (!value.is_string()) {
        refuse("'{}' is not a string", key);
    }
    return value.get<std::string>();
}

std::string_view fullNameOf(const json& object) {
    const json* name = member(object, "name");
    return name != nullptr && name->is_string() ? std::string_view(name->get_ref<const std::string&>())
                                                : std::string_view();
}

std::string nameOf(const json& object) {
    return oneLine(fullNameOf(object), kMaxNameLength);
}

} // namespace cdr::scene::gltf
