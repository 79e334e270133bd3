#pragma once

#include <cdr/base/format_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cdr::scene::gltf {

/// Refuses the file being imported; importGltf() puts the file's name in front of the message.
template <typename... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> what, Args&&... args) {
    throw base::inputError(what, std::forward<Args>(args)...);
}

/// The item that a glTF index means; refuses an index without one. `kind` says what the items are, in the
/// singular.
template <typename Item>
const Item& itemAt(const std::vector<Item>& items, int index, std::string_view kind) {
    if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
        refuse("{} {} does not exist, the file has {}", kind, index, items.size());
    }
    return items[static_cast<std::size_t>(index)];
}

/// The value of an enumeration whose values count from 0 in the order of `names`; nothing where none has this name.
template <typename Value, std::size_t N>
std::optional<Value> valueOf(const std::array<std::string_view, N>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? std::optional(static_cast<Value>(found - names.begin())) : std::nullopt;
}

/// Most bytes of a name in a message, so that the rest of the message stays in view.
inline constexpr std::size_t kMaxNameLength = 100;

/// Text from a hostile file or a library as one printable line of at most `maxLength` bytes and three dots. It takes
/// the same time for text of any length.
/// A character of UTF-8 is in it as a whole or not, and line breaks at the end of so many bytes are left out.
std::string oneLine(std::string_view text, std::size_t maxLength = 400);

} // namespace cdr::scene::gltf
