#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// How a frame's draws come to be and reach the device. The picture is the same to the bit.
enum class Submission : std::uint8_t {
    secondaries, ///< workers record secondary command buffers, one primary executes them (thesis section 5.5)
    primaries,   ///< the control: workers record one primary per rendering scope; no secondaries, one submit
    gpuDriven,   ///< compute passes cull and bin into indirect draws (the thesis' future work)
};

/// All of them.
inline constexpr std::array kSubmissions{Submission::secondaries, Submission::primaries,
                                         Submission::gpuDriven};

/// "secondaries", "primaries" or "gpu-driven".
CDR_EXPORT std::string_view nameOf(Submission submission);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Submission parseSubmission(std::string_view name);

} // namespace cdr::render
