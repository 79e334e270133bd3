#include <cdr/base/error.h>
#include <experiments/timing/timing_document.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

bool isOneLine(std::string_view text) {
    return text.find('\n') == std::string_view::npos;
}

} // namespace

/// Any bytes are the JSON of a run of `timing` with times to divide by, or are refused with base::InputError in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cdr::experiments;
    try {
        const TimingDocument document =
            readTimingDocument({reinterpret_cast<const char*>(data), size}, "other");
        for (const auto& [name, us] : document.medianUs) {
            if (name.empty() || !isOneLine(name) || !std::isfinite(us) || !(us > 0.0)) {
                __builtin_trap();
            }
        }
        if (document.medianUs.empty() || !isOneLine(document.commit + document.device + document.driver)) {
            __builtin_trap();
        }
    } catch (const cdr::base::InputError& error) {
        if (!isOneLine(error.what())) {
            __builtin_trap();
        }
    }
    return 0;
}
