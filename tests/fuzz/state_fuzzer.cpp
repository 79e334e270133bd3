#include <cdr/base/error.h>
#include <experiments/flicker/state.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cdr::experiments {

namespace {

std::optional<FlickerState> unsummedOf(std::string_view text, const FlickerRun& run,
                                       const FlickerState& fresh) {
    try {
        return unsummedState(nlohmann::json::parse(text), run, fresh);
    } catch (const base::InputError&) {
    } catch (const nlohmann::json::exception&) {
    }
    return std::nullopt;
}

} // namespace

} // namespace cdr::experiments

/// Any bytes are a state that the run can have come to, or are refused with base::InputError. A state that is written is
/// read back.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cdr::experiments;
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    const FlickerRun run{.digest = "run", .frames = 4, .pixels = 320 * 180};
    FlickerState fresh;
    for (const char* technique : {"standard", "cdr"}) {
        fresh.results.emplace_back().technique = technique;
    }
    try {
        readState(text, run, fresh, "state.json");
    } catch (const cdr::base::InputError&) {
    }
    const std::optional<FlickerState> state = unsummedOf(text, run, fresh);
    if (!state) {
        return 0;
    }
    for (const FlickerResult& result : state->results) {
        if (state->framesDone > run.frames || !std::isfinite(result.meanFlip()) ||
            !std::isfinite(result.duplication()) || result.wrong.fraction() > 1.0) {
            __builtin_trap();
        }
    }
    const std::string written = stateTextOf(run, *state); // an error of reading it ends the program
    if (stateTextOf(run, readState(written, run, fresh, "state.json")) != written) {
        __builtin_trap();
    }
    return 0;
}
