#include "completions.h"

#include <cdr/base/enum_names.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <options/help_format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::cli {

namespace {

constexpr base::EnumNames<Shell, 3> kShells{"shell", {"bash", "zsh", "fish"}};

std::vector<std::string> commandNames(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    return names;
}

/// "--output" and "-o" of one option.
std::vector<std::string> dashedNames(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> dashedNames(const std::vector<const CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) {
        for (std::string& name : dashedNames(*option)) {
            names.push_back(std::move(name));
        }
    }
    return names;
}

/// Those of a command and, behind them, the program's own, which may stand behind a command too.
std::vector<const CLI::Option*> optionsBehind(const CLI::App& program, const CLI::App& command) {
    std::vector<const CLI::Option*> options = options::shownOptions(command);
    for (const CLI::Option* option : options::shownOptions(program)) {
        const bool isOwn = std::any_of(options.begin(), options.end(), [&](const CLI::Option* own) {
            return own->get_single_name() == option->get_single_name();
        });
        if (!isOwn) {
            options.push_back(option);
        }
    }
    return options;
}

/// The viewer's options, which its help alone knows, as a shell lists them.
constexpr std::string_view kViewerOptions =
    "view --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u";

/// Whether what follows a command is another program's.
bool isOfViewer(const CLI::App& command) {
    return command.get_name() == "view";
}

std::string escaped(const std::string& text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        result += c == '\''                                   ? "'\\''"
                  : special.find(c) != std::string_view::npos ? fmt::format("\\{}", c)
                                                              : std::string(1, c);
    }
    return result;
}

std::string bashScript(const CLI::App& program) {
    std::string cases;
    for (const CLI::App* command : program.get_subcommands({})) {
        const std::string words =
            isOfViewer(*command)
                ? fmt::format("$(\"${{COMP_WORDS[0]}}\" {})", kViewerOptions)
                : fmt::format("'{}'", fmt::join(dashedNames(optionsBehind(program, *command)), " "));
        cases += fmt::format("        {}) words={} ;;\n", command->get_name(), words);
    }
    // Anything else a command takes may be a file, which `-o default` completes.
    return fmt::format(R"(_cdr() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} command= words= word
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case $word in {0}) command=$word; break ;; esac
    done
    case $command in
        '') words='{1} {2}' ;;
{3}    esac
    COMPREPLY=()
    if [[ -z $command || $current == -* ]]; then COMPREPLY=($(compgen -W "$words" -- "$current")); fi
}}
complete -o default -F _cdr cdr
)",
                       fmt::join(commandNames(program), "|"), fmt::join(commandNames(program), " "),
                       fmt::join(dashedNames(options::shownOptions(program)), " "), cases);
}

std::string zshOptions(const std::vector<const CLI::Option*>& options) {
    std::string specs;
    for (const CLI::Option* option : options) {
        for (const std::string& name : dashedNames(*option)) {
            specs +=
                fmt::format(" \\\n            '{}[{}]{}'", name, escaped(option->get_description(), "[]:\\"),
                            options::takesValue(*option) ? ":value:_files" : "");
        }
    }
    return specs;
}

std::string zshScript(const CLI::App& program) {
    std::string commands;
    std::string cases;
    for (const CLI::App* command : program.get_subcommands({})) {
        commands +=
            fmt::format("    '{}:{}'\n", command->get_name(), escaped(command->get_description(), ":\\"));
        const std::string body =
            isOfViewer(*command)
                ? fmt::format("if [[ $PREFIX == -* ]]; then compadd -- $($words[1] {}); else _files; fi",
                              kViewerOptions)
                : fmt::format("_arguments '*:file:_files'{}", zshOptions(optionsBehind(program, *command)));
        cases += fmt::format("    {})\n        {} ;;\n", command->get_name(), body);
    }
    // A file of fpath is the body of a function; sourced, it says whose completion that function is.
    return fmt::format(R"(#compdef cdr
_cdr() {{
local -a commands=(
{1})
case ${{words[(r)({0})]}} in
    '')
        _describe command commands
        _arguments{2} ;;
{3}esac
}}
if [[ $funcstack[1] == _cdr ]]; then _cdr "$@"; else compdef _cdr cdr; fi
)",
                       fmt::join(commandNames(program), "|"), commands,
                       zshOptions(options::shownOptions(program)), cases);
}

std::string fishOptions(const std::vector<const CLI::Option*>& options, const std::string& condition) {
    std::string lines;
    for (const CLI::Option* option : options) {
        if (option->get_positional()) {
            continue;
        }
        lines += fmt::format("complete -c cdr -n '{}'", condition);
        for (const std::string& name : option->get_lnames()) {
            lines += " -l " + name;
        }
        for (const std::string& name : option->get_snames()) {
            lines += " -s " + name;
        }
        lines += fmt::format("{} -d '{}'\n", options::takesValue(*option) ? " -r" : "",
                             escaped(option->get_description(), "\\"));
    }
    return lines;
}

std::string fishScript(const CLI::App& program) {
    std::string lines = fishOptions(options::shownOptions(program), "__fish_use_subcommand");
    for (const CLI::App* command : program.get_subcommands({})) {
        lines += fmt::format("complete -c cdr -f -n __fish_use_subcommand -a {} -d '{}'\n",
                             command->get_name(), escaped(command->get_description(), "\\"));
        const std::string behind = fmt::format("__fish_seen_subcommand_from {}", command->get_name());
        lines += isOfViewer(*command) ? fmt::format("complete -c cdr -n '{}' -a '(cdr {})'\n", behind,
                                                    escaped(std::string(kViewerOptions), ""))
                                      : fishOptions(optionsBehind(program, *command), behind);
    }
    return lines;
}

} // namespace

Shell parseShell(std::string_view name) {
    return kShells.parse(name);
}

std::string completionsOf(const CLI::App& program, Shell shell) {
    switch (shell) {
    case Shell::zsh:
        return zshScript(program);
    case Shell::fish:
        return fishScript(program);
    case Shell::bash:
        break;
    }
    return bashScript(program);
}

} // namespace cdr::cli
