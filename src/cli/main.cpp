#include "commands.h"
#include "exit_status.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/gpu/failure.h>
#include <cdr/platform/process_cpus.h>
#include <cdr/platform/standard_streams.h>
#include <cdr/platform/unfinished_file.h>

#include <fmt/format.h>
#include <options/camera_options.h>
#include <options/help_format.h>
#include <options/help_texts.h>
#include <options/number_checks.h>
#include <program/allocator.h>
#include <program/build_info.h>
#include <ranks/join.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// For a missing or mistyped command CLI11 says only that a "subcommand" is required.
std::string explainMissing(const CLI::App& program, const CLI::RequiredError& error) {
    if (!program.get_subcommands().empty()) {
        return error.what();
    }
    const std::vector<std::string> rest = program.remaining();
    if (rest.empty()) {
        return "a command is missing: cdr --help lists them";
    }
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    return cdr::base::unknownName("command", rest.front(), known);
}

/// Names the first word that nothing takes. CLI11 lists all such words, from the last to the first.
std::string explainExtras(const CLI::App& program) {
    const std::vector<CLI::App*> commands = program.get_subcommands();
    const std::string of = commands.empty() ? std::string("cdr") : "cdr " + commands.front()->get_name();
    const std::vector<std::string> words = program.remaining(true);
    const std::string word = words.empty() ? std::string() : words.front();
    if (!word.starts_with("-")) {
        return fmt::format("{} takes no further word '{}'; {} --help says what it takes", of, word, of);
    }
    const std::string given = word.substr(0, word.find('='));
    if (!commands.empty() && commands.front()->get_option_no_throw(given) != nullptr) {
        return fmt::format("{} is an option of {}: write it behind {}", given, of,
                           commands.front()->get_name());
    }
    std::vector<std::string> names;
    const auto add = [&](const CLI::App& app) {
        for (const CLI::Option* option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names.push_back("--" + name);
            }
        }
    };
    std::for_each(commands.begin(), commands.end(), [&](const CLI::App* command) { add(*command); });
    add(program);
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::optional<std::string_view> nearest = cdr::base::nearestName(given, known);
    return nearest ? fmt::format("{} has no option {}; did you mean {}?", of, given, *nearest)
                   : fmt::format("{} has no option {}; {} --help lists them", of, given, of);
}

/// In the groups that help shows; a command keeps the group that its parent has when it is added.
void addCommands(CLI::App& program, const cdr::cli::GlobalOptions& global) {
    program.group("Look");
    cdr::cli::addRender(program, global);
    cdr::cli::addView(program, global);
    cdr::cli::addDevices(program, global);
    program.group("Measure");
    cdr::cli::addExperiments(program, global);
    cdr::cli::addReport(program, global);
    program.group("Shell");
    cdr::cli::addShellCommands(program, *global.ranks);
    cdr::options::takeDecimals(program);
}

void printOnce(const cdr::ranks::Ranks& ranks, const std::string& text) {
    if (ranks.isFirst()) {
        cdr::platform::printOutput(text);
    }
}

/// Ranks of another version, or on other arguments, would wait for each other forever.
void requireSameProgram(cdr::ranks::Run& ranks, int argc, char** argv) {
    const cdr::program::BuildInfo build = cdr::program::buildInfo();
    std::string text = fmt::format("cdr {} ({})", build.version, build.commit);
    for (int i = 1; i < argc; ++i) {
        text += fmt::format(" {}", argv[i]);
    }
    ranks.requireSame(text, "was started in another way than the first rank: " + text);
}

int run(int argc, char** argv, cdr::ranks::Run& ranks) {
    requireSameProgram(ranks, argc, argv);
    ranks.learnMachine();
    CLI::App program("Cascaded deferred rendering: see far without z-fighting.", "cdr");
    program.require_subcommand(1);
    program.fallthrough(); // global options are found behind the command too
    const auto format = std::make_shared<cdr::options::HelpFormat>();
    format->label("SUBCOMMAND", "COMMAND");
    program.formatter(format);
    cdr::cli::GlobalOptions global;
    global.ranks = &ranks;
    if (ranks.place().node) {
        global.hostCpus = cdr::platform::cpusOfParent().size();
    }
    program.add_option("--device", global.device,
                       std::string(cdr::options::kDeviceHelp) +
                           ". With each, the ranks of a machine take its devices in turn");
    program.add_flag("--validate", global.validate, cdr::options::kValidateHelp);
    program
        .add_option_function<std::string>(
            "--unit", [&global](const std::string& name) { global.unit = cdr::base::parseLengthUnit(name); },
            std::string(cdr::options::kUnitHelp) + ". JSON has scene units")
        ->default_str("none");
    cdr::options::addTextureMemory(program, global.textureMiB);
    cdr::options::addPointRadius(program, global.pointRadius);
    program.add_flag("--quiet", global.quiet, "Print only errors, and which parts of a file are not drawn");
    program.add_flag("--share-machine", global.shareMachine,
                     "Under mpirun: allow several ranks on one machine to measure time");
    program.add_flag(
        "--bind", global.bind,
        "Under mpirun: bind each rank to its share of the machine's processors, or to those that MPI gave it");
    const cdr::program::BuildInfo build = cdr::program::buildInfo();
    program.set_version_flag("--version", fmt::format("cdr {} ({})", build.version, build.commit));
    addCommands(program, global);
    // Of the program alone, not of its commands.
    program.footer("cdr COMMAND --help explains a command. The options above may also follow the command.");
    if (argc <= 1) {
        printOnce(ranks, program.help());
        return 0;
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        std::ostringstream text;
        const int status = program.exit(success, text, text);
        printOnce(ranks, text.str());
        return status;
    } catch (const CLI::RequiredError& error) {
        throw cdr::base::InputError(explainMissing(program, error));
    } catch (const CLI::ExtrasError&) {
        throw cdr::base::InputError(explainExtras(program));
    } catch (const CLI::ParseError& error) {
        throw cdr::base::InputError(error.what());
    }
    return 0;
}

cdr::ranks::Ending endingOf(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const cdr::cli::ExitStatus& asked) {
        return {.status = asked.status()};
    } catch (...) {
        const cdr::gpu::Failure failure = cdr::gpu::failureOf(error);
        return {.status = failure.status, .line = failure.line};
    }
}

/// Runs the program, and tells how that went.
cdr::ranks::Ending outcomeOf(const std::function<int()>& program) {
    try {
        const int status = program();
        cdr::platform::flushStandardOutput();
        return {.status = status};
    } catch (...) {
        return endingOf(std::current_exception());
    }
}

void printLine(const std::string& line) {
    if (!line.empty()) {
        cdr::platform::printError("cdr: " + line);
    }
}

} // namespace

int main(int argc, char** argv) {
    cdr::program::keepFreedMemory();
    cdr::program::useLargePages();
    cdr::platform::removeUnfinishedFilesOnSignals();
    std::unique_ptr<cdr::ranks::Run> ranks;
    const cdr::ranks::Ending joining = outcomeOf([&] {
        ranks = cdr::ranks::join(endingOf, printLine);
        return 0;
    });
    if (ranks == nullptr) {
        printLine(joining.line);
        return joining.status;
    }
    const cdr::ranks::Ending ending = ranks->end(outcomeOf([&] { return run(argc, argv, *ranks); }));
    printLine(ending.line);
    return ending.status;
}
