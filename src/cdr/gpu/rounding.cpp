#include <cdr/gpu/rounding.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace cdr::gpu {

namespace {

// The numbers are those of the SPIR-V specification.
constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kExtension = 10;
constexpr std::uint32_t kEntryPoint = 15;
constexpr std::uint32_t kExecutionMode = 16;
constexpr std::uint32_t kCapability = 17;
constexpr std::uint32_t kRoundingModeRTE = 4462;
constexpr std::uint32_t kRoundingModeRTECapability = 4467;
constexpr std::string_view kFloatControls = "SPV_KHR_float_controls";

std::uint32_t opcodeOf(std::uint32_t word) {
    return word & 0xFFFFu;
}

std::uint32_t firstWord(std::uint32_t opcode, std::size_t words) {
    return static_cast<std::uint32_t>(words << 16u) | opcode;
}

void addCapability(std::vector<std::uint32_t>& words) {
    words.insert(words.end(), {firstWord(kCapability, 2), kRoundingModeRTECapability});
}

void addExtension(std::vector<std::uint32_t>& words) {
    std::array<std::uint32_t, kFloatControls.size() / 4 + 1> text{}; // ends in at least one zero byte
    std::memcpy(text.data(), kFloatControls.data(), kFloatControls.size());
    words.push_back(firstWord(kExtension, 1 + text.size()));
    words.insert(words.end(), text.begin(), text.end());
}

void addModes(std::vector<std::uint32_t>& words, std::uint32_t entryPoint) {
    for (const std::uint32_t bits : {32u, 64u}) {
        words.insert(words.end(), {firstWord(kExecutionMode, 4), entryPoint, kRoundingModeRTE, bits});
    }
}

} // namespace

Spirv roundingToNearestEven(const Spirv& spirv) {
    const std::vector<std::uint32_t>& read = spirv.words;
    Spirv declared;
    std::vector<std::uint32_t>& words = declared.words;
    words.assign(read.begin(), read.begin() + kHeaderWords);
    addCapability(words);
    bool hasExtension = false;
    for (std::size_t at = kHeaderWords; at < read.size();) {
        const std::uint32_t opcode = opcodeOf(read[at]);
        const std::size_t length = read[at] >> 16u;
        if (!hasExtension && opcode != kCapability) { // extensions come behind all capabilities
            addExtension(words);
            hasExtension = true;
        }
        const auto begin = read.begin() + static_cast<std::ptrdiff_t>(at);
        words.insert(words.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
        if (opcode == kEntryPoint) {
            addModes(words, read[at + 2]);
        }
        at += length;
    }
    return declared;
}

} // namespace cdr::gpu
