#include <cdr/host/base64.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace cdr::host {
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

/// Longer than what is encoded at once, and not in whole groups.
TEST(Base64, KeepsEveryByte) {
    Bytes bytes((std::size_t{3} << 20u) + 1000);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 11u);
    }
    EXPECT_EQ(fromBase64(toBase64(bytes)), bytes);
}

TEST(Base64, RefusesWhatIsNone) {
    for (const char* text : {"Z", "Zg=g", "Z g=", "Zm9v\n", "Zm9-"}) {
        EXPECT_FALSE(fromBase64(text).has_value()) << text;
    }
}

} // namespace
} // namespace cdr::host
