#include <cdr/host/process.h>

#include <gtest/gtest.h>
#include <unistd.h>

namespace cdr::host {

TEST(Process, KnowsItsOwnNumberAndFile) {
    EXPECT_EQ(processId(), static_cast<long>(::getpid()));
    ASSERT_TRUE(ownProgram());
    EXPECT_EQ(ownProgram()->filename(), "test_host");
    EXPECT_TRUE(std::filesystem::exists(*ownProgram()));
}

} // namespace cdr::host
