#include "program.h"

#include "application.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/failure.h>
#include <cdr/platform/standard_streams.h>
#include <cdr/platform/unfinished_file.h>

#include <fmt/format.h>

#include <array>
#include <exception>
#include <memory>

namespace cdr::viewer {

void runViewer(const Arguments& arguments, Player* player) {
    std::array<std::shared_ptr<const gpu::ValidationLog>, 2> logs;
    {
        Application application(arguments, player);
        logs = application.validationLogs();
        application.run();
    }
    for (const auto& log : logs) {
        if (const auto messages = log->messages(); !messages.empty()) {
            throw base::runError("{} validation messages, the first: {}", messages.size(), messages.front());
        }
    }
}

int exitStatusOf(const char* program, const std::function<int()>& body) {
    platform::removeUnfinishedFilesOnSignals();
    try {
        const int status = body();
        platform::flushStandardOutput();
        return status;
    } catch (...) {
        const gpu::Failure failure = gpu::failureOf(std::current_exception());
        platform::printError(fmt::format("{}: {}", program, failure.line));
        return failure.status;
    }
}

} // namespace cdr::viewer
