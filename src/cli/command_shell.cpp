#include "commands.h"
#include "completions.h"
#include "manual.h"

#include <cdr/platform/standard_streams.h>

#include <program/build_info.h>

#include <memory>
#include <string>

namespace cdr::cli {

void addShellCommands(CLI::App& program, const ranks::Ranks& ranks) {
    const auto print = [&ranks](const std::string& text) {
        if (ranks.isFirst()) {
            platform::printOutput(text);
        }
    };
    CLI::App* completions = program.add_subcommand(
        "completions", "Print a script with which a shell completes commands and options");
    auto shell = std::make_shared<std::string>();
    completions->add_option("shell", *shell, "bash, zsh or fish")->required();
    completions->callback([&program, shell, print] { print(completionsOf(program, parseShell(*shell))); });
    CLI::App* manual = program.add_subcommand("manual", "Print the manual page in the format of man");
    manual->callback([&program, print] { print(manualOf(program, program::buildInfo().version)); });
}

} // namespace cdr::cli
