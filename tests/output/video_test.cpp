#include "../support/temporary_folder.h"

#include <cdr/base/error.h>

#include <gtest/gtest.h>
#include <output/video.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cdr;
using namespace cdr::output;

class VideoTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!program::isInstalled("ffmpeg")) {
            GTEST_SKIP() << "ffmpeg is not installed";
        }
    }

    const fs::path& folder() const { return m_folder.path(); }

  private:
    cdr::test::TemporaryFolder m_folder;
};

image::ImageRgba8 frameOf(std::uint8_t grey) {
    return {64, 36, image::Rgba8{grey, grey, grey, 255}};
}

/// Asks ffmpeg itself for the frames back, as grey bytes.
std::string decoded(const fs::path& video, const fs::path& folder) {
    const fs::path raw = folder / "raw";
    program::ChildProcess({"ffmpeg", "-loglevel", "error", "-i", video.string(), "-pix_fmt", "gray", "-f",
                           "rawvideo", raw.string()},
                          {})
        .finish();
    std::ifstream stream(raw, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(VideoTest, FramesComeBackAsTheyWentIn) {
    const fs::path path = folder() / "it's; a video.mp4";
    VideoWriter video(path, 64, 36, {.frames = 5, .seconds = 1});
    for (int i = 0; i < 5; ++i) {
        video.add(frameOf(static_cast<std::uint8_t>(50 * i)));
        EXPECT_FALSE(fs::exists(path));
    }
    video.finish();
    const std::string frames = decoded(path, folder());
    ASSERT_EQ(frames.size(), 5u * 64 * 36);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(static_cast<unsigned char>(frames[i * 64 * 36 + 1000]), 50.0 * static_cast<double>(i),
                    4.0);
    }
}

TEST_F(VideoTest, AnUnfinishedVideoLeavesNothing) {
    {
        VideoWriter video(folder() / "v.mp4", 64, 36, {});
        video.add(frameOf(1));
    }
    EXPECT_TRUE(fs::is_empty(folder()));
}

/// A program that does what ffmpeg does on a full disk: it leaves a cut file and ends with status 0.
class CutVideoTest : public VideoTest, public testing::WithParamInterface<const char*> {};

TEST_P(CutVideoTest, IsNotKept) {
    const std::string path = std::getenv("PATH");
    std::ofstream(folder() / "ffmpeg")
        << "#!/bin/sh\ncat >/dev/null\nfor last; do :; done\ncase $last in file:*) printf '" << GetParam()
        << "' >\"${last#file:}\" ;; esac\n";
    fs::permissions(folder() / "ffmpeg", fs::perms::owner_all);
    ::setenv("PATH", (folder().string() + ":" + path).c_str(), 1);
    {
        VideoWriter video(folder() / "v.mp4", 64, 36, {});
        EXPECT_THROW(video.finish(), base::RunError);
    }
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_FALSE(fs::exists(folder() / "v.mp4"));
}

/// Nothing; no index; a box that reaches beyond the end.
INSTANTIATE_TEST_SUITE_P(Cut, CutVideoTest,
                         testing::Values("", "\\0\\0\\0\\10ftyp", "\\0\\0\\0\\10moov\\0\\0\\0\\20mdat"));

TEST_F(VideoTest, RefusesWhatItCannotEncode) {
    EXPECT_THROW(VideoWriter(folder() / "v.mp4", 63, 36, {}), base::InputError);
    EXPECT_THROW(VideoWriter(folder() / "v.mp4", 0, 0, {}), base::InputError);
    EXPECT_THROW(VideoWriter(folder() / "no" / "v.mp4", 64, 36, {}), base::InputError);
    VideoWriter video(folder() / "v.mp4", 64, 36, {});
    EXPECT_THROW(video.add({32, 36}), base::InputError);
}

} // namespace
