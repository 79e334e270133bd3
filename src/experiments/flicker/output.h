#pragma once

#include <cdr/image/image.h>

#include <output/video.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cdr::experiments {

/// The thesis' six videos: two techniques side by side, all frames in 19 seconds.
class PairVideos {
  public:
    /// One FOLDER/LEFT_RIGHT.mp4 per pair of Table 6.1 whose sides are both among the techniques.
    /// base::InputError when there is no such pair, a folder cannot be made, or as VideoWriter.
    PairVideos(const std::filesystem::path& folder, std::span<const std::string> techniques,
               std::uint32_t width, std::uint32_t height, std::uint32_t frames);

    /// One frame's pictures in the techniques' order. base::RunError when an encoder fails.
    void add(const std::vector<image::ImageRgba8>& pictures);

    /// Puts all videos in place, and beside each its first frame as .png. base::RunError when an encoder fails.
    void finish();

  private:
    struct Pair {
        std::size_t left;
        std::size_t right;
        std::filesystem::path path;
        std::unique_ptr<output::VideoWriter> video;
        image::ImageRgba8 poster{}; ///< the first frame
    };
    std::vector<Pair> m_pairs;
};

/// Writes one frame's pictures as FOLDER/TECHNIQUE/NNNN.tga, as the thesis did. base::InputError when a
/// folder cannot be made.
void writeTgaFrames(const std::filesystem::path& folder, std::span<const std::string> techniques,
                    std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures);

} // namespace cdr::experiments
