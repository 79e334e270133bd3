#pragma once

#include <cdr/image/image.h>
#include <experiments/columns.h>

#include <ranks/ranks.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

namespace cdr::experiments {

/// ranks::Ranks::forEachUnit() of results that are JSON, which may hold binary values.
void forEachUnit(ranks::Ranks& ranks, std::size_t count, const std::function<Json(std::size_t unit)>& make,
                 const std::function<void(std::size_t unit, Json made)>& take);

/// Values without pointers as one binary value, which another rank of the same program unpacks.
template <typename Value>
Json packed(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    return Json::binary({bytes, bytes + values.size() * sizeof(Value)});
}

template <typename Value>
std::vector<Value> unpacked(const Json& json) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const Json::binary_t& bytes = json.get_binary();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    }
    return values;
}

Json packedPicture(const image::ImageRgba8& picture);
image::ImageRgba8 unpackedPicture(const Json& json);

} // namespace cdr::experiments
