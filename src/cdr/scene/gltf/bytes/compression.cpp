#include "compression.h"

#include "../checks.h"
#include "../json.h"
#include "meshopt.h"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kLaterMeshopt = "KHR_meshopt_compression";

/// Whether a view lies over its own compressed bytes: a writer that had no others named the buffer it had.
bool isOverCompressed(const BufferRange& view, const json& compressed) {
    // What is no index is not ours to refuse, since nothing of it is read.
    const auto number = [&](const char* key, int fallback) -> std::int64_t {
        const json* value = member(compressed, key);
        return value == nullptr ? fallback : indexOf(*value).value_or(fallback);
    };
    const std::int64_t begin = number("byteOffset", 0);
    const auto viewBegin = static_cast<std::int64_t>(view.offset);
    return number("buffer", -1) == view.buffer && viewBegin < begin + number("byteLength", 0) &&
           begin < viewBegin + static_cast<std::int64_t>(view.length);
}

} // namespace

const json* meshoptOf(const json& view, const BufferRange& range, const std::string& where) {
    const auto isAlone = [&](const json* compressed) {
        return compressed != nullptr && (!range.hasBytes || isOverCompressed(range, *compressed));
    };
    if (const json* compressed = extensionOf(view, kMeshopt); isAlone(compressed)) {
        return compressed;
    }
    if (isAlone(extensionOf(view, kLaterMeshopt))) {
        refuse("{} is there only as {}, which is not supported", where, kLaterMeshopt);
    }
    return nullptr;
}

} // namespace cdr::scene::gltf
