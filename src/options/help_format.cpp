#include "help_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>

namespace cdr::options {

namespace {

constexpr std::size_t kTitleWidth = 30;

/// Words in lines that end before kHelpWidth; all but the first begin with an indent.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::istringstream stream(text);
    std::string lines;
    std::size_t column = indent;
    for (std::string word; stream >> word;) {
        if (column > indent && column + 1 + word.size() > kHelpWidth) {
            lines += "\n" + std::string(indent, ' ');
            column = indent;
        }
        const std::string space = column > indent ? " " : "";
        lines += space + word;
        column += space.size() + word.size();
    }
    return lines;
}

std::string twoColumns(const std::string& title, const std::string& meaning) {
    const std::string name = "  " + title;
    const std::string gap = name.size() + 1 < kTitleWidth ? std::string(kTitleWidth - name.size(), ' ')
                                                          : "\n" + std::string(kTitleWidth, ' ');
    return name + gap + wrapped(meaning, kTitleWidth) + "\n";
}

/// Without what validators add, such as ":INT in [1 - 64]".
std::string typeOf(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return type.substr(0, type.find_first_of(": "));
}

/// A list as the command line takes it: CLI11 prints its default as "[1,2]".
std::string withoutBrackets(const std::string& text) {
    return text.starts_with('[') && text.ends_with(']') ? text.substr(1, text.size() - 2) : text;
}

std::string namesOf(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) {
        names.push_back(option->get_name());
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

bool takesValue(const CLI::Option& option) {
    return !typeOf(option).empty();
}

std::string optionTitle(const CLI::Option& option) {
    if (option.get_positional()) {
        return option.get_name(true, false);
    }
    std::string name = option.get_name(false, true);
    if (!takesValue(option)) {
        return name;
    }
    const bool isOptional = option.get_expected_min() == 0;
    return fmt::format("{} {}{}{}", name, isOptional ? "[" : "", typeOf(option), isOptional ? "]" : "");
}

std::string optionMeaning(const CLI::Option& option) {
    std::string meaning = option.get_description();
    if (option.get_required() && option.nonpositional()) {
        meaning += " (required)";
    }
    if (!option.get_default_str().empty()) {
        meaning += fmt::format(" (default: {})", withoutBrackets(option.get_default_str()));
    }
    if (!option.get_needs().empty()) {
        meaning += fmt::format(" (only with {})", namesOf(option.get_needs()));
    }
    if (!option.get_excludes().empty()) {
        meaning += fmt::format(" (not with {})", namesOf(option.get_excludes()));
    }
    return meaning;
}

std::vector<const CLI::Option*> shownOptions(const CLI::App& app) {
    std::vector<const CLI::Option*> shown =
        app.get_options([](const CLI::Option* option) { return option->get_positional(); });
    for (const std::string& group : app.get_groups()) {
        for (const CLI::Option* option : app.get_options([&](const CLI::Option* each) {
                 return each->nonpositional() && !group.empty() && each->get_group() == group;
             })) {
            shown.push_back(option);
        }
    }
    return shown;
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
    // Two blank lines stand between its groups.
    return CLI::detail::find_and_replace(CLI::Formatter::make_help(app, name, mode), "\n\n\n", "\n\n");
}

std::string HelpFormat::make_option(const CLI::Option* option, bool) const {
    return twoColumns(optionTitle(*option), optionMeaning(*option));
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
    return twoColumns(command->get_name(), command->get_description());
}

std::string HelpFormat::make_description(const CLI::App* app) const {
    return wrapped(app->get_description(), 0) + "\n";
}

} // namespace cdr::options
