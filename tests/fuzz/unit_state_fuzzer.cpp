#include <cdr/base/error.h>

#include <runs/unit_state.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace {

using namespace cdr::runs;

const std::string kDigest(64, 'd');

void read(std::string_view text) {
    try {
        for (const auto& [unit, made] : readUnitState(text, kDigest, "state").made) {
            if (stateLineOf(unit, made).empty()) {
                __builtin_trap();
            }
        }
    } catch (const cdr::base::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) {
            __builtin_trap();
        }
    }
}

} // namespace

/// Any bytes are the state of a run, or are refused with base::InputError in one line. So is what has the right sums.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    read(text);
    read(stateHeadOf(kDigest) + std::string(text));
    read(stateHeadOf(kDigest) + summed(text));
    return 0;
}
