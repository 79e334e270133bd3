#include <cdr/platform/base64.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace cdr::platform {
namespace {

Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

TEST(Base64, IsThatOfRfc4648) {
    for (const auto& [text, encoded] : {std::pair("", ""), std::pair("f", "Zg=="), std::pair("fo", "Zm8="),
                                        std::pair("foo", "Zm9v"), std::pair("foobar", "Zm9vYmFy")}) {
        EXPECT_EQ(toBase64(bytesOf(text)), encoded);
        EXPECT_EQ(fromBase64(encoded), bytesOf(text));
    }
}

/// Many groups, the last of them not whole.
TEST(Base64, KeepsEveryByte) {
    Bytes bytes((std::size_t{3} << 20u) + 1000);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 11u);
    }
    EXPECT_EQ(fromBase64(toBase64(bytes)), bytes);
}

TEST(Base64, RefusesWhatIsNone) {
    for (const char* text : {"Z", "Zg=g", "Z g=", "Zm9v\n", "Zm9-", "Zm9vZ", "Zg===", "===="}) {
        EXPECT_FALSE(fromBase64(text).has_value()) << text;
    }
}

TEST(Base64, TakesSixtyFourDigitsAlone) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int byte = 0; byte < 256; ++byte) {
        const std::string text{'A', static_cast<char>(byte), 'A', 'A'};
        EXPECT_EQ(fromBase64(text).has_value(), digits.find(text[1]) != std::string::npos) << byte;
    }
    for (std::size_t value = 0; value < 64; ++value) {
        EXPECT_EQ(fromBase64(std::string("A") + digits[value]),
                  Bytes{static_cast<std::uint8_t>(value >> 4u)});
        EXPECT_EQ(fromBase64(std::string("A") + digits[value] + "AA"),
                  (Bytes{static_cast<std::uint8_t>(value >> 4u), static_cast<std::uint8_t>(value << 4u), 0}));
    }
}

/// Padding may be left out, and bits that make no byte count as nothing.
TEST(Base64, NeedsNoPadding) {
    for (const char* text : {"Zg==", "Zg=", "Zg", "Zh"}) {
        EXPECT_EQ(fromBase64(text), bytesOf("f")) << text;
    }
}

} // namespace
} // namespace cdr::platform
