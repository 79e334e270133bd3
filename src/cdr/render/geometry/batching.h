#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// How draws become draw commands. The picture is the same to the bit.
enum class Batching : std::uint8_t {
    perObject,     ///< one command per draw, its record in a vertex buffer
    pushConstants, ///< one command per draw, its record pushed before it
    instanced,     ///< one command per run of draws of one kind
};

/// All of them.
inline constexpr std::array kBatchings{Batching::perObject, Batching::pushConstants, Batching::instanced};

/// "per-object", "push-constants" or "instanced".
CDR_EXPORT std::string_view nameOf(Batching batching);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Batching parseBatching(std::string_view name);

} // namespace cdr::render
