#include <cdr/base/error.h>
#include <cdr/gpu/failure.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>

#include <new>
#include <utility>

namespace cdr::gpu {

namespace {

Failure explain(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const base::InputError& bad) {
        return {.status = Failure::kBadInput, .line = bad.what()};
    } catch (const vk::DeviceLostError&) {
        return {.line = "the Vulkan device was lost; its driver crashed or was reset"};
    } catch (const vk::OutOfDeviceMemoryError& memory) {
        return {.line = fmt::format("the Vulkan device is out of memory ({})", memory.what())};
    } catch (const vk::SystemError& vulkan) {
        return {.line = fmt::format("Vulkan: {}", vulkan.what())};
    } catch (const std::bad_alloc&) {
        return {.line = "out of memory"};
    } catch (const std::exception& other) {
        return {.line = other.what()};
    }
}

} // namespace

Failure failureOf(const std::exception_ptr& error) {
    Failure failure = explain(error);
    failure.line = platform::withoutControls(std::move(failure.line));
    return failure;
}

} // namespace cdr::gpu
