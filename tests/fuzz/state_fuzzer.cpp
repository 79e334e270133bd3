#include <cdr/base/error.h>
#include <experiments/flicker/state.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

/// Any bytes are a state that the run can have come to, or are refused with base::InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cdr::experiments;
    const FlickerRun run{.digest = "run", .frames = 4, .pixels = 320 * 180};
    FlickerState fresh;
    fresh.results.resize(2);
    try {
        const FlickerState state =
            readState({reinterpret_cast<const char*>(data), size}, run, fresh, "state.json");
        for (const FlickerResult& result : state.results) {
            if (state.framesDone > run.frames || !std::isfinite(result.meanFlip()) ||
                !std::isfinite(result.duplication()) || result.wrong.fraction() > 1.0) {
                __builtin_trap();
            }
        }
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
