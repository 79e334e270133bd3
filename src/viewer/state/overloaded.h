#pragma once

namespace cdr::viewer {

/// One handler per alternative, for std::visit.
template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>; // which clang 14 does not deduce by itself

} // namespace cdr::viewer
