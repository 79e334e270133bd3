#include "manual.h"

#include <fmt/format.h>
#include <options/help_format.h>

namespace cdr::cli {

namespace {

/// Text escaped so that roff prints it as it is.
std::string plain(const std::string& text) {
    std::string escaped = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text) {
        escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return escaped;
}

std::string optionsOf(const CLI::App& app) {
    std::string page;
    for (const CLI::Option* option : options::shownOptions(app)) {
        page += fmt::format(".TP\n.B {}\n{}\n", plain(options::optionTitle(*option)),
                            plain(options::optionMeaning(*option)));
    }
    return page;
}

} // namespace

std::string manualOf(const CLI::App& program, const std::string& version) {
    std::string page = fmt::format(".TH CDR 1 \"\" \"cdr {}\" \"User Commands\"\n", plain(version));
    page += fmt::format(".SH NAME\ncdr \\- {}\n", plain(program.get_description()));
    page += ".SH SYNOPSIS\n.B cdr\n[\\fIOPTIONS\\fR] \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n";
    page += ".SH OPTIONS\n" + optionsOf(program) + ".SH COMMANDS\n";
    for (const CLI::App* command : program.get_subcommands({})) {
        page += fmt::format(".SS cdr {}\n{}.\n{}", plain(command->get_name()),
                            plain(command->get_description()), optionsOf(*command));
    }
    return page + ".SH EXIT STATUS\n0: done. 1: it failed while it ran. 2: the input is wrong; nothing was "
                  "written. 3: done, and a check that was asked for did not pass.\n";
}

} // namespace cdr::cli
