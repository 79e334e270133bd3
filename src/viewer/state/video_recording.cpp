#include "video_recording.h"

#include <algorithm>

namespace cdr::viewer {

namespace {

std::uint32_t even(std::uint32_t side) {
    return side - side % 2;
}

void copyInto(image::ImageRgba8& frame, const image::ImageRgba8& picture, std::uint32_t width,
              std::uint32_t left) {
    for (std::uint32_t row = 0; row < frame.height; ++row) {
        const auto from =
            picture.pixels.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * picture.width);
        std::copy_n(from, width,
                    frame.pixels.begin() +
                        static_cast<std::ptrdiff_t>(std::size_t{row} * frame.width + left));
    }
}

} // namespace

VideoRecording::VideoRecording(const std::filesystem::path& file, std::size_t sides, std::uint32_t width,
                               std::uint32_t height)
    : m_file(file),
      m_sides(sides),
      m_width(width),
      m_height(height),
      m_frame(even(width) * static_cast<std::uint32_t>(sides), even(height)),
      m_writer(file, m_frame.width, m_frame.height, {.frames = kPicturesPerSecond, .seconds = 1}) {}

bool VideoRecording::add(const image::ImageRgba8& left, const image::ImageRgba8* right, double seconds) {
    const auto fits = [this](const image::ImageRgba8& picture) {
        return picture.width == m_width && picture.height == m_height;
    };
    if (!fits(left) || (right != nullptr) != (m_sides == 2) || (right != nullptr && !fits(*right))) {
        return false;
    }
    m_seconds += seconds;
    const auto due = static_cast<std::uint32_t>(m_seconds * kPicturesPerSecond);
    if (m_pictures < due) {
        copyInto(m_frame, left, even(m_width), 0);
        if (right != nullptr) {
            copyInto(m_frame, *right, even(m_width), even(m_width));
        }
    }
    for (; m_pictures < due; ++m_pictures) {
        m_writer.add(m_frame);
    }
    return true;
}

} // namespace cdr::viewer
