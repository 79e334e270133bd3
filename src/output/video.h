#pragma once

#include <cdr/image/image.h>
#include <cdr/platform/file.h>

#include <program/child_process.h>

#include <cstdint>
#include <filesystem>

namespace cdr::output {

/// How a video plays: `frames` over `seconds`.
struct VideoTiming {
    std::uint32_t frames = 360;
    std::uint32_t seconds = 19;
};

/// base::InputError unless frames of this size can be encoded: both sides even, which H.264's halved colour
/// needs, and at most 16384, and ffmpeg installed. The message names its package. Call before long work.
void requireEncodable(std::uint32_t width, std::uint32_t height);

/// Encodes frames as they come into an .mp4 (H.264). ffmpeg runs as a program of its own, without a shell,
/// and reads raw pixels from its standard input. So no frame is stored.
class VideoWriter {
  public:
    /// @param path whole when finish() returns, absent before.
    /// base::InputError when it cannot be created, or as requireEncodable().
    VideoWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                const VideoTiming& timing);

    /// base::RunError, with ffmpeg's own words, when it has ended; base::InputError for another size.
    void add(const image::ImageRgba8& frame);

    /// Waits for ffmpeg and puts the file in place. base::RunError, with ffmpeg's own words, when it
    /// fails, or when it has not written all of the file.
    void finish();

  private:
    std::uint32_t m_width;
    std::uint32_t m_height;
    std::filesystem::path m_path;
    platform::PendingFile m_file;
    program::ChildProcess m_encoder;
};

} // namespace cdr::output
