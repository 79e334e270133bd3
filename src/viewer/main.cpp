#include "application.h"
#include "resident_memory.h"

#include <cdr/base/error.h>

#include <fmt/format.h>
#include <vulkan/vulkan.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>

namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;

/// One line on standard error, whatever the message holds.
int fail(int status, std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    fmt::print(stderr, "cdr-viewer: {}\n", message);
    return status;
}

/// Runs the program, and says what validation had to say of it, its end included.
void run(const cdr::viewer::Arguments& arguments) {
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
        cdr::viewer::returnLargeBlocksAtOnce();
        const cdr::viewer::ParsedArguments parsed = cdr::viewer::parseArguments(argc, argv);
        if (parsed.exitStatus) {
            return *parsed.exitStatus;
        }
        run(parsed.arguments);
        return 0;
    } catch (const cdr::base::InputError& error) {
        return fail(kBadInput, error.what());
    } catch (const vk::DeviceLostError&) {
        return fail(kFailed, "the Vulkan device was lost; its driver crashed or was reset");
    } catch (const vk::OutOfDeviceMemoryError& error) {
        return fail(kFailed, fmt::format("the Vulkan device is out of memory ({})", error.what()));
    } catch (const vk::SystemError& error) {
        return fail(kFailed, fmt::format("Vulkan: {}", error.what()));
    } catch (const std::bad_alloc&) {
        return fail(kFailed, "out of memory");
    } catch (const std::exception& error) {
        return fail(kFailed, error.what());
    }
}
