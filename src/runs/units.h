#pragma once

#include <cdr/image/image.h>

#include <output/columns.h>
#include <ranks/ranks.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace cdr::runs {

/// A function of ranks::Ranks, with results that are JSON, which may hold binary values.
void forEachUnit(ranks::Ranks& ranks, std::size_t count,
                 const std::function<output::Json(std::size_t unit)>& make,
                 const std::function<void(std::size_t unit, output::Json made)>& take,
                 ranks::Ranks::ForEach forEach = &ranks::Ranks::forEachUnit);

/// Values without pointers as one binary value, which another rank of the same program unpacks.
template <typename Value>
output::Json packed(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    return output::Json::binary({bytes, bytes + values.size() * sizeof(Value)});
}

template <typename Value>
std::vector<Value> unpacked(const output::Json& json) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const output::Json::binary_t& bytes = json.get_binary();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    }
    return values;
}

/// The same of so many values. std::out_of_range where there are others.
template <typename Value>
std::vector<Value> unpacked(const output::Json& json, std::size_t count) {
    std::vector<Value> values = unpacked<Value>(json);
    if (values.size() != count) {
        throw std::out_of_range("other values than were packed");
    }
    return values;
}

/// The values of the first rank, on every rank.
template <typename Value>
std::vector<Value> sharedOf(ranks::Ranks& ranks, const std::vector<Value>& ofFirst) {
    return unpacked<Value>(output::Json::binary(ranks.share(packed(ofFirst).get_binary())));
}

output::Json packedPicture(const image::ImageRgba8& picture);
/// std::out_of_range where it has not as many pixels as it says.
image::ImageRgba8 unpackedPicture(const output::Json& json);

} // namespace cdr::runs
