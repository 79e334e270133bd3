#include <cdr/platform/process.h>

#include <gtest/gtest.h>
#include <unistd.h>

namespace cdr::platform {

TEST(Process, KnowsItsOwnNumberAndFile) {
    EXPECT_EQ(processId(), static_cast<long>(::getpid()));
    ASSERT_TRUE(ownProgram());
    EXPECT_EQ(ownProgram()->filename(), "test_platform");
    EXPECT_TRUE(std::filesystem::exists(*ownProgram()));
}

} // namespace cdr::platform
