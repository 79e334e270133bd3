#pragma once

#include <cdr/image/image.h>

#include <output/video.h>

#include <cstdint>
#include <filesystem>

namespace cdr::viewer {

/// A video of what is shown, both techniques whole and side by side, 30 pictures a second however slowly they come.
class VideoRecording {
  public:
    static constexpr std::uint32_t kPicturesPerSecond = 30;

    /// @param sides pictures beside each other, 1 or 2; width and height of each. What is odd loses its last column or
    /// row. base::InputError as output::VideoWriter.
    VideoRecording(const std::filesystem::path& file, std::size_t sides, std::uint32_t width,
                   std::uint32_t height);

    /// What has been shown for `seconds`. False where it no longer has the size or the sides of the first.
    bool add(const image::ImageRgba8& left, const image::ImageRgba8* right, double seconds);
    /// base::RunError when ffmpeg fails.
    void finish() { m_writer.finish(); }

    double seconds() const { return m_seconds; }
    std::uint32_t pictures() const { return m_pictures; }
    const std::filesystem::path& file() const { return m_file; }

  private:
    std::filesystem::path m_file;
    std::size_t m_sides;
    std::uint32_t m_width;
    std::uint32_t m_height;
    image::ImageRgba8 m_frame;
    output::VideoWriter m_writer;
    double m_seconds = 0.0;
    std::uint32_t m_pictures = 0;
};

} // namespace cdr::viewer
