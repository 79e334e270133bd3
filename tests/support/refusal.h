#pragma once

#include <cdr/base/error.h>

#include <string>

namespace cdr::test {

/// What an error says that an action throws; `otherwise` where it throws none.
template <typename Error>
std::string errorOf(const auto& action, const std::string& otherwise = "") {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return otherwise;
}

std::string inputErrorOf(const auto& action, const std::string& otherwise = "") {
    return errorOf<base::InputError>(action, otherwise);
}
std::string runErrorOf(const auto& action, const std::string& otherwise = "") {
    return errorOf<base::RunError>(action, otherwise);
}

} // namespace cdr::test
