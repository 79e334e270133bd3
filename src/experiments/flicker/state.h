#pragma once

#include "flicker.h"

#include <cdr/gpu/device.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::experiments {

/// How far a flicker run has come.
struct FlickerState {
    std::uint32_t framesDone = 0;
    std::vector<FlickerResult> results; ///< as of those frames, one per technique
};

/// The run that a state belongs to.
struct FlickerRun {
    std::string digest; ///< of everything the results depend on
    std::uint32_t frames = 0;
    std::uint64_t pixels = 0; ///< of a frame
};

/// The text that keeps a state, with the SHA-256 of all that it says.
std::string stateTextOf(const FlickerRun& run, const FlickerState& state);

/// The state that a text of stateTextOf() holds.
/// @param fresh the run's state before its first frame.
/// @param name of the file, which a message begins with.
/// base::InputError, in one line, for a damaged text, one of another run, or counts that are not possible in the run.
FlickerState readState(std::string_view text, const FlickerRun& run, const FlickerState& fresh,
                       const std::string& name);

/// readState() without the sum, which random bytes do not have, so that a fuzz test reaches what is behind it. Also
/// nlohmann::json::exception, for a missing field or one of another type.
FlickerState unsummedState(const nlohmann::json& json, const FlickerRun& run, const FlickerState& fresh);

/// Keeps a run's state in a file from frame to frame, written whole or not at all.
class FlickerStateFile {
  public:
    /// @param options everything in them that bears on the results, with the program's
    /// version and commit and the device, is what a state belongs to.
    FlickerStateFile(std::filesystem::path path, const FlickerOptions& options,
                     const gpu::DeviceInfo& device);

    /// Takes what an earlier run left. Leaves `state` as it is where there is no file. base::InputError as
    /// readState(): other options, another version and another device make another run.
    void load(FlickerState& state) const;

    /// base::InputError when the file cannot be written.
    void save(const FlickerState& state) const;

  private:
    std::filesystem::path m_path;
    FlickerRun m_run;
};

} // namespace cdr::experiments
