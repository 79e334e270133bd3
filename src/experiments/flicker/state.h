#pragma once

#include "flicker.h"

#include <cdr/gpu/device.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cdr::experiments {

/// How far a flicker run has come.
struct FlickerState {
    std::uint32_t framesDone = 0;
    std::vector<FlickerResult> results; ///< as of those frames, one per technique
};

/// Keeps a run's state in a file from frame to frame, written whole or not at all.
class FlickerStateFile {
  public:
    /// @param options techniques filled in; everything in them that bears on the results, with the program's
    /// version and commit and the device, is what a state belongs to.
    FlickerStateFile(std::filesystem::path path, const FlickerOptions& options,
                     const gpu::DeviceInfo& device);

    /// Takes what an earlier run left; leaves `state` as it is where there is no file. base::InputError, in
    /// one line, for a damaged file or one of a run with other options, another version or device.
    void load(FlickerState& state) const;

    /// base::InputError when the file cannot be written.
    void save(const FlickerState& state) const;

  private:
    std::filesystem::path m_path;
    std::string m_digest;
    std::uint32_t m_frames;
};

} // namespace cdr::experiments
