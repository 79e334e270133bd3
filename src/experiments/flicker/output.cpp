#include "output.h"

#include "pairs.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/image/compose.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::experiments {

namespace {

constexpr std::uint32_t kVideoSeconds = 19;

image::ImageRgba8 sideBySide(const image::ImageRgba8& left, const image::ImageRgba8& right) {
    image::ImageRgba8 both(left.width + right.width, left.height);
    image::paste(both, left, 0, 0);
    image::paste(both, right, left.width, 0);
    return both;
}

} // namespace

PairVideos::PairVideos(const std::filesystem::path& folder, std::span<const std::string> techniques,
                       std::uint32_t width, std::uint32_t height, std::uint32_t frames) {
    for (const ThesisPair& pair : kThesisPairs) {
        const auto left = std::find(techniques.begin(), techniques.end(), pair.left);
        const auto right = std::find(techniques.begin(), techniques.end(), pair.right);
        if (left != techniques.end() && right != techniques.end()) {
            m_pairs.push_back({.left = static_cast<std::size_t>(left - techniques.begin()),
                               .right = static_cast<std::size_t>(right - techniques.begin()),
                               .path = folder / fmt::format("{}_{}.mp4", pair.left, pair.right),
                               .video = nullptr});
        }
    }
    if (m_pairs.empty()) {
        throw base::InputError(
            "videos show pairs of standard, cdr, log and logcdr; name at least two of them");
    }
    output::requireEncodable(2 * width, height);
    platform::makeFolder(folder);
    for (Pair& pair : m_pairs) {
        pair.video = std::make_unique<output::VideoWriter>(
            pair.path, 2 * width, height, output::VideoTiming{.frames = frames, .seconds = kVideoSeconds});
    }
}

void PairVideos::add(const std::vector<image::ImageRgba8>& pictures) {
    for (Pair& pair : m_pairs) {
        image::ImageRgba8 both = sideBySide(pictures.at(pair.left), pictures.at(pair.right));
        pair.video->add(both);
        if (pair.poster.pixels.empty()) {
            pair.poster = std::move(both);
        }
    }
}

void PairVideos::finish() {
    for (const Pair& pair : m_pairs) {
        pair.video->finish();
        image::writeImage(std::filesystem::path(pair.path).replace_extension(".png"), pair.poster);
    }
}

void writeTgaFrames(const std::filesystem::path& folder, std::span<const std::string> techniques,
                    std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures) {
    for (std::size_t i = 0; i < techniques.size(); ++i) {
        const std::filesystem::path own = folder / techniques[i];
        platform::makeFolder(own);
        image::writeImage(own / fmt::format("{:04}.tga", frame), pictures.at(i));
    }
}

} // namespace cdr::experiments
