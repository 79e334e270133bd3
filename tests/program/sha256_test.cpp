#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <program/sha256.h>

#include <cstddef>
#include <string>

namespace {

TEST(Sha256, MatchesPublishedVectors) {
    // FIPS 180-4 example and the empty message.
    const std::string abc = "abc";
    EXPECT_EQ(cdr::program::sha256Of(abc),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(cdr::program::sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, HasOneDigestWhetherReadInPartsOrWhole) {
    const cdr::test::TemporaryFolder folder;
    const auto path = [&folder](const char* name) { return folder.path() / name; };
    for (const std::size_t bytes :
         {std::size_t{0}, std::size_t{5}, std::size_t{1} << 20u, (std::size_t{5} << 19u) + 3}) {
        std::string text(bytes, '\0');
        for (std::size_t i = 0; i < bytes; ++i) {
            text[i] = static_cast<char>(i % 251); // no two parts are alike
        }
        cdr::platform::writeText(path("digest"), text);
        const cdr::program::FileDigest digest = cdr::program::digestOfFile(path("digest"), bytes);
        EXPECT_EQ(digest.sha256, cdr::program::sha256Of(text)) << bytes;
        EXPECT_EQ(digest.bytes, bytes);
    }
    EXPECT_THROW(cdr::program::digestOfFile(path("digest"), 1u << 20u), cdr::base::InputError)
        << "it is larger";
    EXPECT_THROW(cdr::program::digestOfFile(path("missing"), 1u), cdr::base::InputError);
}

} // namespace
