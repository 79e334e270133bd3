#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;

constexpr const char* kRig = " --eye-distance 0.4 --converge 12";

class ViewsCommand : public FolderTest {
  protected:
    json row(const std::string& options, const std::string& size = "160x90") {
        succeed("--validate render alley --size " + size + " --json r.json " + options);
        m_document = jsonIn("r.json");
        return m_document["results"][0];
    }
    image::ImageRgba8 picture(const std::string& name) { return readPicture(at(name)); }

    json m_document;
};

TEST_F(ViewsCommand, StereoPicturesNameTheirMode) {
    const json mono = row("-o mono.png");
    EXPECT_EQ(mono["views"], 1);
    EXPECT_EQ(mono["stereo"], "none");
    EXPECT_FALSE(m_document["options"].contains("stereo"));
    for (const std::string mode : {"parallel", "toed-in", "off-axis"}) {
        const json eyes = row("--stereo " + mode + kRig + " -o eyes.png");
        EXPECT_EQ(eyes["views"], 2);
        EXPECT_EQ(eyes["stereo"], mode);
        EXPECT_GT(eyes["draws"], mono["draws"]);
        EXPECT_EQ(m_document["options"]["stereo"], mode);
        EXPECT_EQ(m_document["options"]["eye_distance"], 0.4);
        EXPECT_EQ(m_document["options"]["converge"], 12.0);
        EXPECT_EQ(m_document["options"]["stereo_picture"], "side-by-side");
        const image::ImageRgba8 both = picture("eyes.png");
        EXPECT_EQ(both.width, 320u);
        EXPECT_EQ(both.height, 90u);
        std::size_t differing = 0;
        for (std::uint32_t y = 0; y < both.height; ++y) {
            for (std::uint32_t x = 0; x < 160; ++x) {
                differing += both.at(x, y) != both.at(160 + x, y) ? 1 : 0;
            }
        }
        EXPECT_GT(differing, 500u) << mode;
    }
}

/// Parallel eyes without a distance to converge at are not moved: each half is a picture of `render` from there.
TEST_F(ViewsCommand, EachHalfIsThePictureFromThatEye) {
    const std::string camera = "--technique cdr --direction 0,0,-1 ";
    row(camera + "--eye 0,2,0 --stereo parallel --eye-distance 0.5 -o eyes.png");
    row(camera + "--eye=-0.25,2,0 -o left.png");
    row(camera + "--eye 0.25,2,0 -o right.png");
    const image::ImageRgba8 eyes = picture("eyes.png");
    const image::ImageRgba8 left = picture("left.png");
    const image::ImageRgba8 right = picture("right.png");
    EXPECT_NE(left.pixels, right.pixels);
    for (std::uint32_t y = 0; y < 90; ++y) {
        for (std::uint32_t x = 0; x < 160; ++x) {
            ASSERT_EQ(eyes.at(x, y), left.at(x, y));
            ASSERT_EQ(eyes.at(160 + x, y), right.at(x, y));
        }
    }
}

TEST_F(ViewsCommand, AnaglyphsHaveRedOfTheLeftEye) {
    row(std::string("--stereo parallel") + kRig + " -o eyes.png");
    const json made = row(std::string("--stereo parallel") + kRig + " --stereo-picture anaglyph -o both.png");
    EXPECT_EQ(m_document["options"]["stereo_picture"], "anaglyph");
    const image::ImageRgba8 eyes = picture("eyes.png");
    const image::ImageRgba8 anaglyph = picture("both.png");
    ASSERT_EQ(anaglyph.width, 160u);
    for (std::uint32_t y = 0; y < 90; ++y) {
        for (std::uint32_t x = 0; x < 160; ++x) {
            EXPECT_EQ(anaglyph.at(x, y)[0], eyes.at(x, y)[0]);
            EXPECT_EQ(anaglyph.at(x, y)[1], eyes.at(160 + x, y)[1]);
            EXPECT_EQ(anaglyph.at(x, y)[2], eyes.at(160 + x, y)[2]);
        }
    }
}

/// Ids, distances and the truth of both eyes; the truth is cast from each eye.
TEST_F(ViewsCommand, OtherOutputsAreOfBothEyesToo) {
    for (const char* aov : {"linear", "id", "distance", "normal", "cascade", "coverage"}) {
        row(std::string("--stereo toed-in --aov ") + aov + kRig + " -o a.png");
        EXPECT_EQ(picture("a.png").width, 320u) << aov;
    }
    const json wrong =
        row(std::string("--technique anchored --stereo toed-in --aov wrong") + kRig + " -o w.png");
    EXPECT_GT(wrong["pixels"], 10000);
    EXPECT_LT(wrong["wrong_fraction"], 0.001);
}

TEST_F(ViewsCommand, SixViewsAreTheSidesOfACube) {
    const json six = row("--views six -o six.png", "64x64");
    EXPECT_EQ(six["views"], 6);
    EXPECT_EQ(m_document["options"]["views"], "six");
    const image::ImageRgba8 sides = picture("six.png");
    EXPECT_EQ(sides.width, 6u * 64);
    row("--fov 90 -o ahead.png", "64x64");
    const image::ImageRgba8 ahead = picture("ahead.png");
    std::size_t like = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            like += sides.at(5 * 64 + x, y) == ahead.at(x, y) ? 1 : 0;
        }
    }
    EXPECT_GT(like, 64u * 60); // other cascades round otherwise
}

TEST_F(ViewsCommand, FramesOfARunAreThoseOfRunsOfTheirOwn) {
    row(std::string("--stereo parallel --frames 3") + kRig + " -o f%d.png --hash");
    const std::string last = m_document["results"][2]["hash"];
    EXPECT_EQ(row(std::string("--stereo parallel --technique reversed --frame 2") + kRig)["hash"], last);
}

} // namespace

} // namespace cdr::cli_test
