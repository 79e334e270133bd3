#include "video.h"

#include "whole_file.h"

#include <cdr/base/format_error.h>

#include <fmt/format.h>

#include <iterator>
#include <sstream>

namespace cdr::output {

namespace {

std::vector<std::string> encoderArguments(const std::filesystem::path& output, std::uint32_t width,
                                          std::uint32_t height, const VideoTiming& timing) {
    // Flicker is noise, which a coarser crf smooths.
    std::istringstream words(fmt::format(
        "ffmpeg -hide_banner -loglevel error -f rawvideo -pixel_format rgba -video_size {}x{} -framerate {}/{} "
        "-i pipe:0 -c:v libx264 -preset veryfast -crf 20 -pix_fmt yuv420p -movflags +faststart -y",
        width, height, timing.frames, timing.seconds));
    std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
    arguments.push_back("file:" + std::filesystem::absolute(output).string()); // which may hold blanks
    return arguments;
}

const std::filesystem::path& checked(const std::filesystem::path& path, std::uint32_t width,
                                     std::uint32_t height) {
    requireEncodable(width, height);
    platform::requireWritable(path);
    return path;
}

} // namespace

void requireEncodable(std::uint32_t width, std::uint32_t height) {
    constexpr std::uint32_t kMaxSide = 16384;
    const bool odd = width % 2 != 0 || height % 2 != 0;
    if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide || odd) {
        throw base::inputError("a video's sides must be even and 2 to {} pixels, not {}x{}", kMaxSide, width,
                               height);
    }
    if (!program::isInstalled("ffmpeg")) {
        throw base::InputError("videos need ffmpeg, which is not installed (Debian, Ubuntu: ffmpeg)");
    }
}

VideoWriter::VideoWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                         const VideoTiming& timing)
    : m_width(width),
      m_height(height),
      m_path(path),
      m_file(checked(path, width, height)),
      m_encoder(encoderArguments(m_file.temporary(), width, height, timing), {}) {}

void VideoWriter::add(const image::ImageRgba8& frame) {
    if (frame.width != m_width || frame.height != m_height) {
        throw base::inputError("video: a frame of {}x{} in a video of {}x{}", frame.width, frame.height,
                               m_width, m_height);
    }
    m_encoder.write({frame.pixels.front().data(), frame.pixels.size() * sizeof(image::Rgba8)});
}

void VideoWriter::finish() {
    m_encoder.finish();
    requireWhole(m_file.temporary(), m_path, "ffmpeg");
    m_file.commit();
}

} // namespace cdr::output
