#include "json.h"

#include "checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxDepth = 128;
constexpr std::size_t kMaxValues = 32'000'000;

constexpr std::array<std::string_view, 18> kIndexKeys{
    "buffer",        "bufferView", "byteLength", "byteOffset", "byteStride", "camera",
    "componentType", "count",      "index",      "indices",    "material",   "mesh",
    "mode",          "sampler",    "scene",      "skin",       "source",     "texCoord"};
constexpr std::array<std::string_view, 2> kIndexArrayKeys{"children", "nodes"};

struct NumberArray {
    const char* key;
    std::size_t length;
};
constexpr std::array<NumberArray, 4> kNodeArrays{
    {{"translation", 3}, {"rotation", 4}, {"scale", 3}, {"matrix", 16}}};

template <std::size_t Count>
bool contains(const std::array<std::string_view, Count>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

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
    if (!value.is_number_unsigned() ||
        value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
        refuse("'{}' is {}, not an integer from 0 to {}", oneLine(key), oneLine(value.dump()),
               std::numeric_limits<int>::max());
    }
    return value.get<int>();
}

void requireSoundIndices(const json& value, bool insideAttributes);

void requireSoundMember(const std::string& key, const json& value, bool insideAttributes) {
    if (contains(kIndexArrayKeys, key)) {
        if (!value.is_array()) {
            refuse("'{}' is not an array", key);
        }
        for (const json& element : value) {
            if (!element.is_object()) {
                requireIndex(element, key);
            }
        }
    } else if (key == "sparse" && value.is_object()) {
        for (const auto& [part, inner] : value.items()) {
            if (inner.is_object()) { // its indices are no index
                requireSoundIndices(inner, false);
            } else {
                requireSoundMember(part, inner, false);
            }
        }
        return;
    } else if (insideAttributes || contains(kIndexKeys, key)) {
        requireIndex(value, key);
        return;
    }
    requireSoundIndices(value, key == "attributes");
}

void requireSoundIndices(const json& value, bool insideAttributes) {
    if (value.is_array()) {
        for (const json& element : value) {
            requireSoundIndices(element, false);
        }
    } else if (value.is_object()) {
        for (const auto& [key, inner] : value.items()) {
            // What these hold is not ours to know.
            if (key != "extras" && key != "extensions") {
                requireSoundMember(key, inner, insideAttributes);
            }
        }
    }
}

void requireNumbers(const json& node, const NumberArray& wanted) {
    const json* value = member(node, wanted.key);
    if (value == nullptr) {
        return;
    }
    if (!value->is_array() || value->size() != wanted.length ||
        !std::all_of(value->begin(), value->end(), [](const json& element) { return element.is_number(); })) {
        refuse("node '{}': '{}' is not {} numbers", nameOf(node), wanted.key, wanted.length);
    }
}

void requireNumber(const json& material, const json& owner, const char* key) {
    const json* value = member(owner, key);
    if (value != nullptr && !value->is_number()) {
        refuse("material '{}': '{}' is not a number", nameOf(material), key);
    }
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

std::optional<std::string> stringMember(const json& object, const char* key) {
    const json* value = member(object, key);
    return value == nullptr ? std::nullopt : std::optional(requireString(*value, key));
}

std::optional<int> indexMember(const json& object, const char* key) {
    const json* value = member(object, key);
    return value == nullptr ? std::nullopt : std::optional(requireIndex(*value, key));
}

std::string requireString(const json& value, const char* key) {
    if (!value.is_string()) {
        refuse("'{}' is not a string", key);
    }
    return value.get<std::string>();
}

std::string nameOf(const json& object) {
    const json* name = member(object, "name");
    return name != nullptr && name->is_string() ? oneLine(name->get<std::string>()) : std::string();
}

void requireSoundNumbers(const json& root) {
    requireSoundIndices(root, false);
    for (const json& node : arrayMember(root, "nodes")) {
        for (const NumberArray& wanted : kNodeArrays) {
            requireNumbers(node, wanted);
        }
    }
    for (const json& material : arrayMember(root, "materials")) {
        requireNumber(material, material, "alphaCutoff");
        if (const json* factors = member(material, "pbrMetallicRoughness")) {
            requireNumber(material, *factors, "metallicFactor");
            requireNumber(material, *factors, "roughnessFactor");
        }
    }
}

} // namespace cdr::scene::gltf
