#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <viewer/session/arguments.h>
#include <viewer/session/render_failure.h>
#include <viewer/session/startup.h>

#include <gtest/gtest.h>

#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace cdr::viewer_test {

namespace {

using namespace viewer;

TEST(FreeName, TakesAFileThatCannotBeSeenForOne) {
    const test::TemporaryFolder folder;
    const std::string stem = (folder.path() / "cdr").string();
    EXPECT_EQ(freeName(stem, ".png"), stem + "-0001.png");
    std::filesystem::create_symlink("cdr-0001.png", stem + "-0001.png"); // to itself
    EXPECT_EQ(freeName(stem, ".png"), stem + "-0002.png");
}

/// Parameters of a technique are separated by commas too.
TEST(ComparedPair, IsSplitWhereBothSidesAreTechniques) {
    const std::string fitted = "anchored/fitted:0.00001px,max=32";
    for (const auto& [left, right] :
         {std::pair<std::string, std::string>{fitted, "cdr"}, {"standard", fitted}, {fitted, fitted}}) {
        const auto pair = parsePair(left + "," + right);
        EXPECT_EQ(pair[0], depth::parseTechnique(left));
        EXPECT_EQ(pair[1], depth::parseTechnique(right));
    }
    for (const char* bad : {"standard", "standard,", "standard,nonsense", "nonsense,cdr", ",", ""}) {
        EXPECT_THROW(parsePair(bad), base::InputError) << bad;
    }
}

template <typename Error>
std::string noticeOf(const Error& error) {
    try {
        throw error;
    } catch (...) {
        return explainFailure().message;
    }
}

TEST(RenderFailures, AreToldWhereAnotherRequestMaySucceed) {
    EXPECT_EQ(noticeOf(base::InputError("no such scene")), "no such scene");
    EXPECT_EQ(noticeOf(base::RunError("unreadable")), "unreadable");
    EXPECT_EQ(noticeOf(std::bad_alloc()), "out of memory");
    EXPECT_NE(noticeOf(vk::OutOfDeviceMemoryError("x")).find("memory"), std::string::npos);
    const auto noThread = std::make_error_code(std::errc::resource_unavailable_try_again);
    EXPECT_NE(noticeOf(std::system_error(noThread)).find("temporarily unavailable"), std::string::npos);
    EXPECT_THROW(noticeOf(vk::DeviceLostError("x")), vk::DeviceLostError);
    EXPECT_THROW(noticeOf(std::bad_exception()), std::bad_exception);
}

} // namespace

} // namespace cdr::viewer_test
