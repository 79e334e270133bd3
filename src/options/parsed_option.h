#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace cdr::options {

/// Adds an option whose text `parse` turns into the value. Help shows the value's name, by its nameOf(), as the default.
/// @param value must live as long as the command.
template <typename Value, typename Parse>
CLI::Option* addNamed(CLI::App& command, const char* names, Value& value, Parse parse,
                      const std::string& help) {
    return command
        .add_option_function<std::string>(
            names, [&value, parse](const std::string& text) { value = parse(text); }, help)
        ->default_str(std::string(nameOf(value)));
}

/// The same for a value that may stay as it is: an empty text counts as none. Help shows no default.
template <typename Value, typename Parse>
CLI::Option* addParsed(CLI::App& command, const char* names, Value& value, Parse parse,
                       const std::string& help) {
    return command.add_option_function<std::string>(
        names,
        [&value, parse](const std::string& text) {
            if (!text.empty()) {
                value = parse(text);
            }
        },
        help);
}

} // namespace cdr::options
