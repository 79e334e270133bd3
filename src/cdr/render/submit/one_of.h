#pragma once

#include <memory>
#include <variant>

namespace cdr::render {

/// Owns one of several things, or none.
template <typename... Things>
using OneOf = std::variant<std::monostate, std::unique_ptr<Things>...>;

/// The thing of a type; null where the owner has none, or another.
template <typename Thing, typename... Things>
Thing* findIn(const OneOf<Things...>& owner) {
    const auto* found = std::get_if<std::unique_ptr<Thing>>(&owner);
    return found != nullptr ? found->get() : nullptr;
}

} // namespace cdr::render
