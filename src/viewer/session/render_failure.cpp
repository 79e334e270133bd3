#include "render_failure.h"

#include <cdr/base/error.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace cdr::viewer {

RenderFailure explainFailure() {
    std::string message;
    try {
        throw;
    } catch (const base::InputError& error) {
        message = error.what();
    } catch (const base::RunError& error) {
        message = error.what();
    } catch (const vk::OutOfDeviceMemoryError&) {
        message = "the device has too little memory for that";
    } catch (const vk::OutOfHostMemoryError&) {
        message = "out of memory";
    } catch (const vk::SystemError&) { // a std::system_error too
        throw;
    } catch (const std::system_error& error) { // such as of a thread that cannot start
        message = error.what();
    } catch (const std::bad_alloc&) {
        message = "out of memory";
    }
    return {std::move(message), std::current_exception()};
}

} // namespace cdr::viewer
