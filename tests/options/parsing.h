#pragma once

#include <CLI/CLI.hpp>
#include <cdr/base/error.h>

#include <string>
#include <vector>

namespace cdr::options {

/// Why a command refuses some words, in what parses them or in CLI11; empty where it takes them.
inline std::string refusalOf(CLI::App& command, std::vector<std::string> words) {
    try {
        command.parse(std::vector<std::string>(words.rbegin(), words.rend())); // the last one first
    } catch (const base::InputError& error) {
        return error.what();
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return "";
}

} // namespace cdr::options
