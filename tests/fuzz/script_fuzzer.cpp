#include <cdr/base/error.h>
#include <viewer/drive/script.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

namespace {

using namespace cdr::viewer;

/// What a step may ask of the window.
bool isUsable(const ScriptStep& step) {
    if (const auto* size = std::get_if<WindowSize>(&step)) {
        return size->width > 0 && size->height > 0;
    }
    if (const auto* event = std::get_if<InputEvent>(&step)) {
        const auto* button = std::get_if<ButtonInput>(event);
        return button == nullptr || (button->button >= 0 && button->button < 5);
    }
    return true;
}

} // namespace

/// Any text is a script of usable steps, or is refused with base::InputError in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        for (const ScriptStep& step : parseScript({reinterpret_cast<const char*>(data), size}, "script")) {
            if (!isUsable(step)) {
                __builtin_trap();
            }
        }
    } catch (const cdr::base::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) {
            __builtin_trap();
        }
    }
    return 0;
}
