#include <cdr/base/error.h>
#include <cdr/host/host_memory.h>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <string>

namespace {

using namespace cdr;

/// A limit of the process' address space, until the end of the scope.
class AddressLimit {
  public:
    /// @param more bytes than the process has now.
    explicit AddressLimit(std::uint64_t more) {
        ::getrlimit(RLIMIT_AS, &m_before);
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        rlimit limit = m_before;
        limit.rlim_cur = pages * 4096 + more;
        ::setrlimit(RLIMIT_AS, &limit);
    }
    ~AddressLimit() { ::setrlimit(RLIMIT_AS, &m_before); }
    AddressLimit(const AddressLimit&) = delete;
    AddressLimit& operator=(const AddressLimit&) = delete;

  private:
    rlimit m_before{};
};

constexpr std::uint64_t kMebibyte = 1 << 20;

TEST(HostMemory, MoreThanTheSystemHasIsRefused) {
    ASSERT_TRUE(host::freeHostBytes().has_value());
    EXPECT_THROW(host::requireHostBytes(std::uint64_t{1} << 60, "a picture"), base::RunError);
    EXPECT_NO_THROW(host::requireHostBytes(1, "a pixel"));
}

TEST(HostMemory, TheLimitOfTheProcessCounts) {
    const AddressLimit limit(256 * kMebibyte);
    EXPECT_LE(host::freeHostBytes().value_or(0), 256 * kMebibyte);
    try {
        host::requireHostBytes(512 * kMebibyte, "a picture");
        ADD_FAILURE() << "not refused";
    } catch (const base::RunError& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find("a picture needs 512.0 MiB of memory, "), std::string::npos) << line;
        EXPECT_NE(line.find(" MiB are free"), std::string::npos) << line;
    }
}

} // namespace
