#pragma once

namespace cdr::viewer {

/// One handler per alternative, for std::visit.
template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

} // namespace cdr::viewer
