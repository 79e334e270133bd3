#include <cdr/base/error.h>
#include <cdr/gpu/failure.h>
#include <viewer/session/application.h>
#include <viewer/session/resident_memory.h>

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

namespace {

/// Runs the program, and says what validation had to say of it, its end included.
void run(const cdr::viewer::Arguments& arguments) {
    if (arguments.soakSeconds) {
        cdr::viewer::keepFreeMemoryLow();
    }
    std::array<std::shared_ptr<const cdr::gpu::ValidationLog>, 2> logs;
    {
        cdr::viewer::Application application(arguments);
        logs = application.validationLogs();
        application.run();
    }
    for (const auto& log : logs) {
        if (const auto messages = log->messages(); !messages.empty()) {
            throw cdr::base::RunError(
                fmt::format("{} validation messages, the first: {}", messages.size(), messages.front()));
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const cdr::viewer::ParsedArguments parsed = cdr::viewer::parseArguments(argc, argv);
        if (parsed.exitStatus) {
            return *parsed.exitStatus;
        }
        run(parsed.arguments);
        return 0;
    } catch (...) {
        const cdr::gpu::Failure failure = cdr::gpu::failureOf(std::current_exception());
        fmt::print(stderr, "cdr-viewer: {}\n", failure.line);
        return failure.status;
    }
}
