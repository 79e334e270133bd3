#include "../support/refusal.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>

namespace cdr::image {
namespace {

namespace fs = std::filesystem;

ImageRgba8 noise(std::uint32_t width, std::uint32_t height) {
    std::mt19937 random(7);
    ImageRgba8 image(width, height);
    for (Rgba8& pixel : image.pixels) {
        for (std::uint8_t& value : pixel) {
            value = static_cast<std::uint8_t>(random() & 0xff);
        }
    }
    return image;
}

std::string refusal(const std::vector<std::uint8_t>& encoded) {
    return test::inputErrorOf([&] { decodeImage(encoded, "picture"); }, "decoded");
}

void expectOneLineRefusal(const std::vector<std::uint8_t>& encoded) {
    const std::string message = refusal(encoded);
    EXPECT_TRUE(message.starts_with("picture: ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// Overwrites the big-endian sizes of a PNG's header and mends its checksum, so that only the size is wrong.
std::vector<std::uint8_t> withPngSize(std::vector<std::uint8_t> png, std::uint32_t width,
                                      std::uint32_t height) {
    const auto store = [&png](std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) {
            png[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
        }
    };
    store(16, width);
    store(20, height);
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= png[i];
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
        }
    }
    store(29, ~crc);
    return png;
}

class Folder : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return m_folder.path() / name; }
    std::size_t filesInside() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()));
    }

  private:
    test::TemporaryFolder m_folder;
};

TEST(Png, ComesBackAsItWas) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 5u}, {257u, 64u}}) {
        const ImageRgba8 image = noise(width, height);
        EXPECT_EQ(decodeImage(encodePng(image), "picture"), image);
    }
}

TEST(Png, IsTheSameBytesEachTime) {
    EXPECT_EQ(encodePng(noise(64, 48)), encodePng(noise(64, 48)));
}

TEST(Png, WithoutPixelsIsRefused) {
    EXPECT_THROW(encodePng(ImageRgba8()), base::InputError);
}

TEST(Png, CutAnywhereIsRefused) {
    const std::vector<std::uint8_t> png = encodePng(noise(16, 16));
    // libspng does not read the checksum of the empty end marker, the last four bytes.
    for (std::size_t size = 0; size < png.size() - 4; ++size) {
        expectOneLineRefusal({png.begin(), png.begin() + static_cast<std::ptrdiff_t>(size)});
    }
}

TEST(Png, OneWrongByteOfItsDataIsRefused) {
    const std::vector<std::uint8_t> png = encodePng(noise(16, 16));
    for (std::size_t at = 45; at < png.size() - 16; at += 7) {
        std::vector<std::uint8_t> damaged = png;
        damaged[at] ^= 0x20;
        expectOneLineRefusal(damaged);
    }
}

TEST(Png, OverTheLimitsIsRefusedByItsHeader) {
    const std::vector<std::uint8_t> png = encodePng(noise(16, 16));
    EXPECT_EQ(withPngSize(png, 16, 16), png) << "the helper must keep the checksum right";
    EXPECT_NE(refusal(withPngSize(png, kMaxDecodedSide + 1, 1)).find("over the limit"), std::string::npos);
    EXPECT_NE(refusal(withPngSize(png, 1, kMaxDecodedSide + 1)).find("over the limit"), std::string::npos);
    EXPECT_NE(refusal(withPngSize(png, 16384, 16384)).find("over the limit"), std::string::npos);
    EXPECT_NE(refusal(withPngSize(png, 0xffffffff, 0xffffffff)), "decoded");
}

TEST(Png, ThatCannotHoldItsPixelsIsRefusedBeforeAllocation) {
    const std::string message = refusal(withPngSize(encodePng(noise(16, 16)), 8192, 8192));
    EXPECT_NE(message.find("cannot hold"), std::string::npos) << message;
}

TEST(Png, OfOneColourIsNotTakenForDamaged) {
    // The most compressible picture, which the check for damage must accept.
    const ImageRgba8 image(2048, 2048, {9, 9, 9, 255});
    EXPECT_EQ(decodeImage(encodePng(image), "picture"), image);
}

TEST(Png, Of16BitsIsRoundedToTheNearestOf8) {
    // 2x1 pixels: 0x0000 0x0080 0x0081 0x00ff, then 0x8000 0xff00 0xff7f 0xffff.
    const std::vector<std::uint8_t> png{
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
        0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x10, 0x06, 0x00, 0x00, 0x00, 0xa4, 0xb2, 0xa3, 0xc9, 0x00,
        0x00, 0x00, 0x18, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x05, 0xc1, 0x81, 0x01, 0x00, 0x00, 0x04, 0xc0,
        0xa0, 0x3e, 0xc7, 0xe5, 0x53, 0xb0, 0x4e, 0x2b, 0x4d, 0x3d, 0x27, 0x83, 0x06, 0xfc, 0xe9, 0x6c, 0x76,
        0xee, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    const ImageRgba8 image = decodeImage(png, "picture");
    EXPECT_EQ(image.pixels, (std::vector<Rgba8>{{0, 0, 1, 1}, {128, 254, 255, 255}}));
}

TEST(Png, Of16BitsComparesAllBitsWithTheTransparentColour) {
    // 2x1 grey pixels 0x00ff and 0x00fe, of which 0x00fe is transparent.
    const std::vector<std::uint8_t> png{
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
        0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x10, 0x00, 0x00, 0x00, 0x00, 0x81, 0xd9, 0xfc, 0x15, 0x00,
        0x00, 0x00, 0x02, 0x74, 0x52, 0x4e, 0x53, 0x00, 0xfe, 0x2c, 0x96, 0x12, 0x23, 0x00, 0x00, 0x00, 0x0d,
        0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60, 0xf8, 0xcf, 0xf0, 0x0f, 0x00, 0x04, 0x00, 0x01, 0xfe,
        0xdb, 0xa6, 0x0d, 0xcf, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    const ImageRgba8 image = decodeImage(png, "picture");
    EXPECT_EQ(image.pixels, (std::vector<Rgba8>{{1, 1, 1, 255}, {1, 1, 1, 0}}));
}

TEST(Image, OfAnotherFormatIsRefused) {
    expectOneLineRefusal({});
    expectOneLineRefusal({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0});
}

class Jpeg : public testing::Test {
  protected:
    void SetUp() override {
        m_bytes = platform::readFile(fs::path(CDR_SOURCE_DIR) / "tests" / "assets" / "stone.jpg", 1u << 24);
    }
    std::vector<std::uint8_t> m_bytes;
};

TEST_F(Jpeg, DecodesOpaque) {
    const ImageRgba8 image = decodeImage(m_bytes, "picture");
    EXPECT_EQ(image.width, 128u);
    EXPECT_EQ(image.height, 128u);
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](const Rgba8& p) { return p[3] == 255; }));
    EXPECT_TRUE(std::ranges::any_of(image.pixels, [](const Rgba8& p) { return p[0] > 100; }));
}

TEST_F(Jpeg, CutOffIsRefused) {
    for (const std::size_t size :
         {std::size_t{3}, std::size_t{200}, m_bytes.size() / 2, m_bytes.size() - 100}) {
        expectOneLineRefusal({m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    }
}

TEST_F(Jpeg, OverTheLimitsIsRefusedByItsHeader) {
    // Start-of-frame marker: FF C0 or C2, length, precision, height, width.
    const auto isFrame = [](std::uint8_t a, std::uint8_t b) { return a == 0xff && (b == 0xc0 || b == 0xc2); };
    const auto frame = std::adjacent_find(m_bytes.begin(), m_bytes.end(), isFrame);
    ASSERT_NE(frame, m_bytes.end());
    std::fill(frame + 5, frame + 9, std::uint8_t{0x7f});
    EXPECT_NE(refusal(m_bytes).find("over the limit"), std::string::npos) << refusal(m_bytes);
    std::fill(frame + 5, frame + 9, std::uint8_t{0});
    *(frame + 5) = *(frame + 7) = 0x40; // 16384x16384
    m_bytes.resize(1000);
    EXPECT_NE(refusal(m_bytes).find("over the limit"), std::string::npos) << refusal(m_bytes);
    *(frame + 5) = *(frame + 7) = 0x1f; // 7936x7936 in 1000 bytes
    EXPECT_NE(refusal(m_bytes).find("cannot hold"), std::string::npos) << refusal(m_bytes);
}

/// A JPEG without Huffman tables, whose quantisation table is of ones.
/// @param frame its segment from the marker on. @param scan so too, with the data that follows.
std::vector<std::uint8_t> jpegOf(const std::vector<std::uint8_t>& frame,
                                 const std::vector<std::uint8_t>& scan) {
    std::vector<std::uint8_t> jpeg{0xff, 0xd8, 0xff, 0xdb, 0, 67, 0};
    jpeg.insert(jpeg.end(), 64, std::uint8_t{1});
    jpeg.insert(jpeg.end(), frame.begin(), frame.end());
    jpeg.insert(jpeg.end(), scan.begin(), scan.end());
    jpeg.insert(jpeg.end(), {0xff, 0xd9});
    return jpeg;
}

TEST(JpegKinds, OfArithmeticCodingMayBeOfFewBytes) {
    const std::vector<std::uint8_t> jpeg = jpegOf({0xff, 0xc9, 0, 11, 8, 4, 0, 4, 0, 1, 1, 0x11, 0},
                                                  {0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x1e, 0xb7, 0x80});
    EXPECT_EQ(decodeImage(jpeg, "picture"), ImageRgba8(1024, 1024, {128, 128, 128, 255}));
    std::vector<std::uint8_t> large = jpeg;
    large[76] = large[78] = 0x40; // 16384x16384
    EXPECT_NE(refusal(large).find("over the limit"), std::string::npos) << refusal(large);
}

TEST(JpegKinds, OfASamplingWithoutANameIsDecoded) {
    const std::vector<std::uint8_t> jpeg =
        jpegOf({0xff, 0xc9, 0, 17, 8, 0, 8, 0, 24, 3, 1, 0x31, 0, 2, 0x11, 0, 3, 0x11, 0},
               {0xff, 0xda, 0, 12, 3, 1, 0, 2, 0x11, 3, 0x11, 0, 63, 0, 0x30});
    EXPECT_EQ(decodeImage(jpeg, "picture"), ImageRgba8(24, 8, {128, 128, 128, 255}));
}

TEST(JpegKinds, ThatTheLibraryCannotDecodeAreNotCalledDamaged) {
    const std::vector<std::uint8_t> scan{0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0};
    const auto refusalOf = [&scan](const std::vector<std::uint8_t>& frame) {
        return refusal(jpegOf(frame, scan));
    };
    EXPECT_EQ(
        refusalOf({0xff, 0xc0, 0, 20, 8, 0, 8, 0, 8, 4, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0, 4, 0x11, 0}),
        "picture: JPEG with CMYK colours is not supported");
    EXPECT_EQ(refusalOf({0xff, 0xc0, 0, 17, 8, 0, 8, 0, 8, 3, 1, 0x31, 0, 2, 0x21, 0, 3, 0x11, 0}),
              "picture: JPEG with fractional sampling is not supported");
    EXPECT_EQ(refusalOf({0xff, 0xc1, 0, 11, 12, 0, 8, 0, 8, 1, 1, 0x11, 0}),
              "picture: JPEG with 12 bits a sample is not supported");
    EXPECT_EQ(refusalOf({0xff, 0xc3, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0}),
              "picture: JPEG with lossless or hierarchical coding is not supported");
}

TEST(Tga, HasTheHeaderAndPixelsOfTheFormat) {
    ImageRgba8 image(258, 3);
    image.at(0, 0) = {1, 2, 3, 4};
    image.at(257, 2) = {5, 6, 7, 8};
    const std::vector<std::uint8_t> tga = encodeTga(image);
    const std::vector<std::uint8_t> header{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 3, 0, 24, 0x20};
    ASSERT_EQ(tga.size(), 18u + 258u * 3u * 3u);
    EXPECT_TRUE(std::equal(header.begin(), header.end(), tga.begin()));
    EXPECT_EQ((std::vector<std::uint8_t>{tga.begin() + 18, tga.begin() + 21}),
              (std::vector<std::uint8_t>{3, 2, 1}));
    EXPECT_EQ((std::vector<std::uint8_t>{tga.end() - 3, tga.end()}), (std::vector<std::uint8_t>{7, 6, 5}));
}

TEST(Tga, RefusesSizesItsHeaderCannotHold) {
    EXPECT_THROW(encodeTga(ImageRgba8()), base::InputError);
    EXPECT_THROW(encodeTga(ImageRgba8(65536, 1)), base::InputError);
    EXPECT_NO_THROW(encodeTga(ImageRgba8(65535, 1)));
}

TEST_F(Folder, WriteImageGoesByTheExtension) {
    const ImageRgba8 image = noise(8, 4);
    writeImage(file("a.png"), image);
    writeImage(file("a.TGA"), image);
    EXPECT_EQ(platform::readFile(file("a.png"), 1u << 20), encodePng(image));
    EXPECT_EQ(platform::readFile(file("a.TGA"), 1u << 20), encodeTga(image));
    EXPECT_THROW(writeImage(file("a.jpg"), image), base::InputError);
    EXPECT_THROW(writeImage(file("a"), image), base::InputError);
    EXPECT_THROW(writeImage(file("missing/a.png"), image), base::InputError);
    EXPECT_EQ(filesInside(), 2u);
}

TEST(Codec, TheSizeIsReadFromTheHeaderAlone) {
    std::vector<std::uint8_t> png = encodePng(noise(13, 7));
    EXPECT_EQ(sizeOfEncoded(png, "picture"), (PictureSize{13, 7}));
    png.resize(png.size() - 20); // cut off inside of its pixels
    EXPECT_EQ(sizeOfEncoded(png, "picture"), (PictureSize{13, 7}));
    const auto refusalOf = [](const std::vector<std::uint8_t>& encoded) -> std::string {
        return test::inputErrorOf([&] { sizeOfEncoded(encoded, "picture"); }, "accepted");
    };
    EXPECT_EQ(refusalOf({1, 2, 3}), "picture: neither PNG nor JPEG");
    EXPECT_EQ(refusalOf({0xff, 0xd8, 0xff}).substr(0, 22), "picture: damaged JPEG:");
    EXPECT_EQ(refusalOf(withPngSize(png, 20000, 3)),
              "picture: 20000x3 pixels is over the limit of 16384 a side and 67108864 in all");
    EXPECT_NE(refusalOf(withPngSize(png, 8000, 8000)).find("cannot hold 8000x8000 pixels"),
              std::string::npos);
}

TEST(Codec, TheSizeOfAJpegIsReadFromItsHeader) {
    const std::vector<std::uint8_t> jpeg =
        platform::readFile(CDR_SOURCE_DIR "/tests/assets/stone.jpg", 1u << 20u);
    const ImageRgba8 picture = decodeImage(jpeg, "stone");
    EXPECT_EQ(sizeOfEncoded(jpeg, "stone"), (PictureSize{picture.width, picture.height}));
}

} // namespace
} // namespace cdr::image
