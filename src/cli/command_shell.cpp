#include "commands.h"
#include "completions.h"
#include "manual.h"

#include <cdr/platform/standard_streams.h>

#include <program/build_info.h>

#include <memory>
#include <string>

namespace cdr::cli {

void addShellCommands(CLI::App& program) {
    CLI::App* completions = program.add_subcommand(
        "completions", "Print a script with which a shell completes commands and options");
    auto shell = std::make_shared<std::string>();
    completions->add_option("shell", *shell, "bash, zsh or fish")->required();
    completions->callback(
        [&program, shell] { platform::printOutput(completionsOf(program, parseShell(*shell))); });
    CLI::App* manual = program.add_subcommand("manual", "Print the manual page in the format of man");
    manual->callback([&program] { platform::printOutput(manualOf(program, program::buildInfo().version)); });
}

} // namespace cdr::cli
