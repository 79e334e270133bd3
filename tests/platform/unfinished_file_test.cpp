#include "../support/temporary_folder.h"

#include <cdr/platform/file.h>
#include <cdr/platform/unfinished_file.h>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <memory>
#include <vector>

namespace cdr::platform {

namespace {

namespace fs = std::filesystem;

/// How a process of its own ends that calls removeUnfinishedFilesOnSignals() and then `body`.
int endOf(const std::function<void()>& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        removeUnfinishedFilesOnSignals();
        body();
        ::_exit(0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

class SignalTest : public testing::TestWithParam<int> {
  protected:
    /// A shell ignores some signals in what it starts in the background.
    void SetUp() override { std::signal(GetParam(), SIG_DFL); }
};

TEST_P(SignalTest, EndsTheProcessAndWhatItHadNotFinished) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "old") << "old";
    const int status = endOf([&] {
        const PendingFile first(folder.path() / "old");
        std::ofstream(first.temporary()) << "half";
        const PendingFile second(folder.path() / "new.png");
        const PendingFile third(folder.path() / "whole");
        third.commit();
        ::raise(GetParam());
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
    EXPECT_EQ(readFile(folder.path() / "old", 10), (Bytes{'o', 'l', 'd'}));
    EXPECT_TRUE(fs::exists(folder.path() / "whole"));
}

INSTANTIATE_TEST_SUITE_P(All, SignalTest,
                         testing::Values(SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU));

TEST(UnfinishedFile, OneThatIsIgnoredStaysIgnored) {
    std::signal(SIGHUP, SIG_IGN); // as nohup does
    const int status = endOf([] { ::raise(SIGHUP); });
    std::signal(SIGHUP, SIG_DFL);
    EXPECT_TRUE(WIFEXITED(status));
}

TEST(UnfinishedFile, AFileBeyondTheLimitOfSizesIsAnError) {
    const test::TemporaryFolder folder;
    const int status = endOf([&] {
        const rlimit limit{.rlim_cur = 1000, .rlim_max = 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            writeFile(folder.path() / "a", Bytes(2000));
        } catch (const std::exception& error) {
            ::_exit(std::string(error.what()).find("File too large") != std::string::npos ? 7 : 8);
        }
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_TRUE(folder.isEmpty());
}

/// More than are remembered, many times over: a place is free again when its file is finished.
TEST(UnfinishedFile, PlacesAreUsedAgain) {
    const test::TemporaryFolder folder;
    const int status = endOf([&] {
        for (int i = 0; i < 1000; ++i) {
            writeText(folder.path() / "a", "whole");
        }
        std::vector<std::unique_ptr<PendingFile>> files;
        for (int i = 0; i < 20; ++i) {
            files.push_back(std::make_unique<PendingFile>(folder.path() / std::to_string(i)));
        }
        ::raise(SIGTERM);
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

} // namespace

} // namespace cdr::platform
