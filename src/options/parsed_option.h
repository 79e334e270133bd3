#pragma once

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>

#include <set>
#include <string>
#include <vector>

namespace cdr::options {

/// Adds an option that sets a value. Help shows what it is as the default.
/// @param value must live as long as the command.
template <typename Value>
CLI::Option* addValue(CLI::App& command, const char* names, Value& value, const std::string& help) {
    return command.add_option(names, value, help)->capture_default_str();
}

/// The same for several values with commas between.
template <typename Value>
CLI::Option* addList(CLI::App& command, const char* names, std::vector<Value>& values,
                     const std::string& help) {
    return addValue(command, names, values, help)->delimiter(',');
}

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

/// base::InputError where a name is there twice: it would be measured twice, and both would write the same pictures.
inline void requireDistinct(const std::vector<std::string>& names) {
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (!seen.insert(name).second) {
            throw base::inputError("{} is given twice", name);
        }
    }
}

/// Adds an option of several texts with commas between, which `parse` turns into the values instead of those that are there.
/// base::InputError as requireDistinct().
/// @param values must live as long as the command.
template <typename Value, typename Parse>
CLI::Option* addParsedList(CLI::App& command, const char* names, std::vector<Value>& values, Parse parse,
                           const std::string& help) {
    return command
        .add_option_function<std::vector<std::string>>(
            names,
            [&values, parse](const std::vector<std::string>& texts) {
                requireDistinct(texts);
                values.clear();
                for (const std::string& text : texts) {
                    values.push_back(parse(text));
                }
            },
            help)
        ->expected(CLI::detail::expected_max_vector_size)
        ->delimiter(',');
}

/// Refuses the empty text, such as that of a script's variable which is not set.
/// @param what a file or a folder
inline CLI::Validator namesOne(const std::string& what) {
    return {[what](const std::string& text) { return text.empty() ? "names no " + what : std::string(); },
            ""};
}

/// Adds an option that takes the path of a file.
template <typename Path>
CLI::Option* addFile(CLI::App& command, const char* names, Path& path, const std::string& help) {
    return command.add_option(names, path, help)->type_name("FILE")->check(namesOne("file"));
}

/// Adds an option that takes the path of a folder.
template <typename Path>
CLI::Option* addFolder(CLI::App& command, const char* names, Path& path, const std::string& help) {
    return command.add_option(names, path, help)->type_name("FOLDER")->check(namesOne("folder"));
}

} // namespace cdr::options
