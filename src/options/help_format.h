#pragma once

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace cdr::options {

/// What a line of help is at most, in characters.
inline constexpr std::size_t kHelpWidth = 100;

/// Help in two columns that fits kHelpWidth: names and what they take, then what they mean.
class HelpFormat : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
    std::string make_option(const CLI::Option* option, bool isPositional) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_description(const CLI::App* app) const override;
};

/// Whether an option is no flag.
bool takesValue(const CLI::Option& option);

/// "-o,--output TEXT": an option's names and what it takes. Of a positional, its name.
std::string optionTitle(const CLI::Option& option);

/// What an option means, whether it is required, its default, what it needs and what it excludes.
std::string optionMeaning(const CLI::Option& option);

/// The options of an app that help shows, in its groups' order, positionals first.
std::vector<const CLI::Option*> shownOptions(const CLI::App& app);

} // namespace cdr::options
