#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace cdr::image {
namespace {

namespace fs = std::filesystem;

class Exr : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return m_folder.path() / name; }
    bool folderIsEmpty() const { return m_folder.isEmpty(); }

  private:
    test::TemporaryFolder m_folder;
};

ExrChannel ramp(const std::string& name, std::uint32_t width, std::uint32_t height, float step) {
    ExrChannel channel{name, ImageFloat(width, height)};
    for (std::size_t i = 0; i < channel.values.pixels.size(); ++i) {
        channel.values.pixels[i] = static_cast<float>(i) * step;
    }
    return channel;
}

ImageFloat readChannel(const fs::path& path, const std::string& name) {
    Imf::InputFile file(path.c_str());
    const auto window = file.header().dataWindow();
    ImageFloat values(static_cast<std::uint32_t>(window.max.x - window.min.x + 1),
                      static_cast<std::uint32_t>(window.max.y - window.min.y + 1), -1.0f);
    Imf::FrameBuffer pixels;
    pixels.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.pixels.data()), sizeof(float),
                                   sizeof(float) * values.width));
    file.setFrameBuffer(pixels);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

void writeExr(const fs::path& path, const std::vector<ExrChannel>& channels) {
    platform::writeFile(path, encodeExr(path, channels));
}

TEST_F(Exr, ChannelsComeBackBitForBit) {
    const fs::path path = file("a.exr");
    std::vector<ExrChannel> channels{ramp("R", 37, 21, 1.0f / 3.0f), ramp("distance", 37, 21, 1e7f)};
    channels[1].values.at(5, 7) = std::numeric_limits<float>::infinity();
    channels[1].values.at(6, 7) = std::numeric_limits<float>::denorm_min();
    writeExr(path, channels);
    for (const ExrChannel& channel : channels) {
        const ImageFloat read = readChannel(path, channel.name);
        ASSERT_EQ(read.width, 37u);
        ASSERT_EQ(read.height, 21u);
        for (std::size_t i = 0; i < read.pixels.size(); ++i) {
            ASSERT_EQ(std::bit_cast<std::uint32_t>(read.pixels[i]),
                      std::bit_cast<std::uint32_t>(channel.values.pixels[i]))
                << channel.name << " pixel " << i;
        }
    }
}

TEST_F(Exr, IsZipCompressedFloat32) {
    const fs::path path = file("a.exr");
    writeExr(path, std::vector{ramp("Z", 64, 64, 1.0f)});
    const Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    const Imf::Channel* channel = file.header().channels().findChannel("Z");
    ASSERT_NE(channel, nullptr);
    EXPECT_EQ(channel->type, Imf::FLOAT);
}

TEST_F(Exr, IsTheSameBytesEachTime) {
    writeExr(file("a.exr"), std::vector{ramp("Z", 64, 64, 0.7f)});
    writeExr(file("b.exr"), std::vector{ramp("Z", 64, 64, 0.7f)});
    EXPECT_EQ(platform::readFile(file("a.exr"), 1u << 20), platform::readFile(file("b.exr"), 1u << 20));
}

TEST_F(Exr, RefusesWhatItCannotWriteAndLeavesNothing) {
    const fs::path path = file("a.exr");
    EXPECT_THROW(writeExr(path, {}), base::InputError);
    EXPECT_THROW(writeExr(path, std::vector{ramp("Z", 0, 0, 1.0f)}), base::InputError);
    EXPECT_THROW(writeExr(path, std::vector{ramp("", 2, 2, 1.0f)}), base::InputError);
    EXPECT_THROW(writeExr(path, std::vector{ramp("Z", 2, 2, 1.0f), ramp("Z", 2, 2, 1.0f)}), base::InputError);
    EXPECT_THROW(writeExr(path, std::vector{ramp("Y", 2, 2, 1.0f), ramp("Z", 2, 3, 1.0f)}), base::InputError);
    EXPECT_TRUE(folderIsEmpty());
}

} // namespace
} // namespace cdr::image
