#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace cdr::experiments {

/// Called before each step, such as a frame, with how many of all are done.
using Progress = std::function<void(std::size_t done, std::size_t all)>;
/// The same with what the step makes.
using NamedProgress = std::function<void(std::size_t done, std::size_t all, const std::string& what)>;

} // namespace cdr::experiments
