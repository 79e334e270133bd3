#include "../support/shell.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <report/folder.h>
#include <report/manifest.h>
#include <report/mount_point.h>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <set>
#include <string>

namespace cdr::report_test {

namespace {

namespace fs = std::filesystem;
using namespace cdr::report;

class PendingFolderTest : public testing::Test {
  protected:
    fs::path path(const std::string& name) const { return m_folder.path() / name; }
    std::set<std::string> namesIn(const std::string& name) const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(path(name))) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }

  private:
    test::TemporaryFolder m_folder;
};

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

/// A report of two files.
void writeReport(const fs::path& folder, const std::string& text) {
    fs::create_directory(folder / "data");
    write(folder / "data" / "a.json", text);
    write(folder / kManifest, R"({"command":"report","files":["data/a.json"]})");
}

TEST_F(PendingFolderTest, GoesUnlessItIsCommittedOrKept) {
    { const PendingFolder folder(path("r")); }
    EXPECT_TRUE(namesIn(".").empty());
    fs::path kept;
    {
        PendingFolder folder(path("r"));
        folder.keep();
        kept = folder.temporary();
    }
    EXPECT_TRUE(fs::is_directory(kept));
}

TEST_F(PendingFolderTest, StaysWhenItCannotBePutInPlace) {
    fs::path kept;
    {
        PendingFolder folder(path("r"));
        kept = folder.temporary();
        writeReport(kept, "hours of work");
        folder.keep();
        fs::create_directory(path("r"));
        write(path("r") / "foreign", "x");
        EXPECT_THROW(folder.commit(), base::InputError);
    }
    EXPECT_EQ(test::readText(kept / "data" / "a.json"), "hours of work");
    EXPECT_EQ(namesIn("r"), std::set<std::string>{"foreign"});
}

/// What a killed process left, else what stands in place of it.
TEST_F(PendingFolderTest, TakesUpWhatAStateLeft) {
    fs::path kept;
    {
        PendingFolder folder(path("r"), "s");
        EXPECT_FALSE(folder.isKept());
        kept = folder.temporary();
        writeReport(kept, "half a report");
        folder.keep();
    }
    EXPECT_NE(PendingFolder(path("r"), "another").temporary(), kept);
    {
        PendingFolder folder(path("r"), "s");
        EXPECT_EQ(folder.temporary(), kept);
        EXPECT_TRUE(folder.isKept());
        EXPECT_EQ(test::readText(kept / "data" / "a.json"), "half a report");
        folder.commit();
    }
    EXPECT_EQ(namesIn("."), std::set<std::string>{"r"});
    {
        const PendingFolder folder(path("r"), "s");
        EXPECT_EQ(test::readText(folder.temporary() / "data" / "a.json"), "half a report");
    }
    EXPECT_EQ(namesIn("."), std::set<std::string>{"r"});
    EXPECT_EQ(test::readText(path("r") / "data" / "a.json"), "half a report");
    {
        const PendingFolder folder(path("r"));
        EXPECT_TRUE(fs::is_empty(folder.temporary()));
    }
    const fs::path before = fs::current_path();
    fs::current_path(path("r"));
    for (int start = 0; start < 2; ++start) { // in the folder itself
        PendingFolder folder(".", "s");
        folder.keep();
    }
    fs::current_path(before);
    EXPECT_EQ(namesIn("r").size(), 3u);
}

/// As on a full disk.
TEST_F(PendingFolderTest, LeavesNothingWhereTheEarlierReportCannotBeCopied) {
    {
        const PendingFolder folder(path("r"));
        writeReport(folder.temporary(), "more than fits");
        fs::rename(folder.temporary(), path("r"));
    }
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{.rlim_cur = 1, .rlim_max = before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    bool failed = false;
    try {
        const PendingFolder folder(path("r"), "s");
    } catch (const fs::filesystem_error&) {
        failed = true;
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(failed);
    EXPECT_EQ(namesIn("."), std::set<std::string>{"r"});
}

/// A shell that stands in the folder stays in it.
TEST_F(PendingFolderTest, FillsTheCurrentFolder) {
    fs::create_directory(path("r"));
    writeReport(path("r"), "old");
    const fs::path before = fs::current_path();
    fs::current_path(path("r"));
    PendingFolder folder(".");
    writeReport(folder.temporary(), "new");
    folder.keep();
    folder.commit();
    EXPECT_EQ(test::readText("data/a.json"), "new"); // as the process sees it, by the folder it stands in
    fs::current_path("data");
    EXPECT_THROW(PendingFolder(".."), base::InputError);
    fs::current_path(before);
    EXPECT_EQ(namesIn("r"), (std::set<std::string>{"data", kManifest}));
}

/// As a container's volume is.
TEST_F(PendingFolderTest, FillsAMountPoint) {
    const fs::path volume = path("a volume");
    fs::create_directory(volume);
    // In a name space of this process alone, so that nothing stays mounted.
    const bool isAlone =
        ::unshare(CLONE_NEWNS) == 0 && ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
    if (!isAlone || ::mount("none", volume.c_str(), "tmpfs", 0, "size=64k") != 0) {
        GTEST_SKIP() << "nothing can be mounted here: " << std::strerror(errno);
    }
    EXPECT_TRUE(isMountPoint(volume));
    EXPECT_FALSE(isMountPoint(volume.parent_path()));
    for (const char* text : {"old", "new"}) {
        PendingFolder folder(volume);
        writeReport(folder.temporary(), text);
        folder.keep();
        folder.commit();
        EXPECT_EQ(test::readText(volume / "data" / "a.json"), text);
        EXPECT_EQ(namesIn("a volume"), (std::set<std::string>{"data", kManifest}));
    }
    EXPECT_EQ(namesIn("."), std::set<std::string>{"a volume"});
    ::umount2(volume.c_str(), MNT_DETACH);
}

} // namespace

} // namespace cdr::report_test
