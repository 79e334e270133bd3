#include "../support/refusal.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/input_file.h>
#include <cdr/platform/json_text.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;
using cdr::base::InputError;
using cdr::platform::Bytes;

class FileTest : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(m_folder); }
    void TearDown() override { fs::remove_all(m_folder); }
    fs::path path(const char* name) const { return m_folder / name; }
    std::size_t filesInFolder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }

    /// Whether requireWritable() refuses a file to a user who is nobody, and root is not; without root, to this one.
    static bool isRefusedToNobody(const fs::path& file) {
        constexpr ::uid_t kNobody = 65534;
        const ::pid_t child = ::fork();
        if (child == 0) {
            if (::geteuid() == 0 && ::setuid(kNobody) != 0) {
                ::_exit(2);
            }
            try {
                cdr::platform::requireWritable(file);
                ::_exit(0);
            } catch (const InputError&) {
                ::_exit(1);
            } catch (...) {
                ::_exit(2);
            }
        }
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) < 2) << status;
        return WIFEXITED(status) && WEXITSTATUS(status) == 1;
    }

  private:
    fs::path m_folder = fs::path(testing::TempDir()) / ("cdr_file_test_" + std::to_string(::getpid()));
};

TEST_F(FileTest, WritesAndReadsBack) {
    const Bytes bytes{1, 2, 3, 0, 255};
    cdr::platform::writeFile(path("a.bin"), bytes);
    EXPECT_EQ(cdr::platform::readFile(path("a.bin"), 5), bytes);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, RefusesMissingFoldersAndTooLargeFiles) {
    cdr::platform::writeFile(path("a.bin"), Bytes(10));
    EXPECT_THROW(cdr::platform::readFile(path("a.bin"), 9), InputError);
    EXPECT_THROW(cdr::platform::readFile(path("b.bin"), 9), InputError);
    EXPECT_THROW(cdr::platform::readFile(path(""), 9), InputError);
    EXPECT_THROW(cdr::platform::readFile("/dev/zero", 9), InputError);
}

TEST_F(FileTest, ReadsPartsOfAnOpenFile) {
    cdr::platform::writeFile(path("a.bin"), Bytes{1, 2, 3, 4, 5});
    EXPECT_THROW(cdr::platform::InputFile(path("a.bin"), 4), InputError);
    EXPECT_THROW(cdr::platform::InputFile(path("b.bin"), 9), InputError);
    EXPECT_THROW(cdr::platform::InputFile("/dev/zero", 9), InputError);
    const cdr::platform::InputFile file(path("a.bin"), 5);
    EXPECT_EQ(file.size(), 5u);
    Bytes part(3);
    EXPECT_TRUE(file.read(2, part));
    EXPECT_EQ(part, (Bytes{3, 4, 5}));
    EXPECT_TRUE(file.read(0, part));
    EXPECT_EQ(part, (Bytes{1, 2, 3}));
    EXPECT_FALSE(file.read(3, part)) << "reads beyond the end";
    EXPECT_TRUE(file.read(5, {}));
    cdr::platform::writeFile(path("a.bin"), Bytes{9, 9, 9, 9, 9});
    EXPECT_TRUE(file.read(0, part));
    EXPECT_EQ(part, (Bytes{1, 2, 3})) << "another file has its name now";
}

TEST_F(FileTest, AFileThatBecomesShorterCannotBeRead) {
    cdr::platform::writeFile(path("a.bin"), Bytes{1, 2, 3, 4, 5});
    const cdr::platform::InputFile file(path("a.bin"), 5);
    fs::resize_file(path("a.bin"), 2);
    Bytes part(3);
    EXPECT_FALSE(file.read(0, part));
    EXPECT_EQ(file.size(), 5u);
}

TEST_F(FileTest, AFailedWriteLeavesTheOldFileAndNothingElse) {
    cdr::platform::writeFile(path("a.bin"), Bytes{7});
    EXPECT_THROW(cdr::platform::writeBesideThenRename(path("a.bin"),
                                                      [](const fs::path& temporary) {
                                                          std::ofstream(temporary) << "half";
                                                          throw std::runtime_error("midway");
                                                      }),
                 std::runtime_error);
    EXPECT_EQ(cdr::platform::readFile(path("a.bin"), 9), Bytes{7});
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, TellsWhetherAPathCanBeWritten) {
    EXPECT_NO_THROW(cdr::platform::requireWritable(path("new.png")));
    EXPECT_EQ(filesInFolder(), 0u);
    EXPECT_THROW(cdr::platform::requireWritable(path("no/such/folder.png")), InputError);
    EXPECT_THROW(cdr::platform::requireWritable(path(".")), InputError);
    EXPECT_THROW(cdr::platform::writeFile(path("no/such/folder.png"), Bytes{1}), InputError);
}

/// What a long run made would be lost if its file were refused at the end.
TEST_F(FileTest, RefusesAReadOnlyFileAtTheStart) {
    fs::permissions(path(""), fs::perms::all);
    cdr::platform::writeText(path("a.bin"), "old");
    fs::permissions(path("a.bin"), fs::perms(0666));
    if (isRefusedToNobody(path("a.bin"))) {
        GTEST_SKIP() << "the folder of temporary files is not everybody's";
    }
    fs::permissions(path("a.bin"), fs::perms(0444));
    EXPECT_TRUE(isRefusedToNobody(path("a.bin")));
    fs::create_symlink("a.bin", path("link"));
    EXPECT_TRUE(isRefusedToNobody(path("link")));
    EXPECT_EQ(filesInFolder(), 2u);
}

TEST_F(FileTest, RefusesAFileThatAStickyFolderKeepsForItsOwner) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "a file of another user needs rights that this process lacks";
    }
    fs::permissions(path(""), fs::perms::all);
    cdr::platform::writeText(path("a.bin"), "old");
    fs::permissions(path("a.bin"), fs::perms(0666));
    if (isRefusedToNobody(path("a.bin"))) {
        GTEST_SKIP() << "the folder of temporary files is not everybody's";
    }
    fs::permissions(path(""), fs::perms::all | fs::perms::sticky_bit);
    EXPECT_TRUE(isRefusedToNobody(path("a.bin")));
    EXPECT_FALSE(isRefusedToNobody(path("new.bin")));
    EXPECT_NO_THROW(cdr::platform::requireWritable(path("a.bin"))); // root may
}

/// The test makes a null device of its own, so that a failure cannot replace the system's.
TEST_F(FileTest, WritesIntoADeviceAndLeavesIt) {
    if (::mknod(path("null").c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0 || !std::ofstream(path("null"))) {
        GTEST_SKIP() << "making a device needs rights that this process lacks";
    }
    cdr::platform::requireWritable(path("null"));
    cdr::platform::writeFile(path("null"), Bytes{1, 2, 3});
    EXPECT_TRUE(fs::is_character_file(path("null")));
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, NamesTheOutputThatIsFull) {
    const int full = ::open("/dev/full", O_WRONLY);
    ASSERT_GE(full, 0);
    const std::string name = "/dev/fd/" + std::to_string(full);
    EXPECT_EQ(cdr::test::runErrorOf([&] {
                  cdr::platform::writeFile(name, Bytes{1, 2, 3});
              }),
              name + ": write failed: No space left on device");
    ::close(full);
}

TEST_F(FileTest, WritesIntoAFifoAndLeavesIt) {
    ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
    cdr::platform::requireWritable(path("fifo"));
    std::string read;
    std::thread reader([&] { std::getline(std::ifstream(path("fifo")), read); });
    cdr::platform::writeText(path("fifo"), "through\n");
    reader.join();
    EXPECT_EQ(read, "through");
    EXPECT_TRUE(fs::is_fifo(path("fifo")));
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, WritesWhereALinkPointsAndKeepsTheLink) {
    fs::create_directories(path("folder"));
    fs::create_symlink("folder/new.bin", path("link"));
    cdr::platform::writeFile(path("link"), Bytes{1});
    cdr::platform::writeFile(path("link"), Bytes{2});
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(cdr::platform::readFile(path("folder/new.bin"), 9), Bytes{2});
    EXPECT_EQ(filesInFolder(), 2u);
    fs::create_symlink("loop", path("loop"));
    EXPECT_THROW(cdr::platform::writeFile(path("loop"), Bytes{1}), InputError);
    fs::create_symlink("folder", path("link to a folder"));
    EXPECT_THROW(cdr::platform::writeFile(path("link to a folder"), Bytes{1}), InputError);
}

TEST_F(FileTest, WritesIntoAnOpenDescriptorWhereItStands) {
    const int file = ::open(path("a.txt").c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_GE(file, 0);
    ASSERT_EQ(::write(file, "before ", 7), 7);
    cdr::platform::writeText("/dev/fd/" + std::to_string(file), "within");
    ASSERT_EQ(::write(file, " after", 6), 6);
    ::close(file);
    const Bytes bytes = cdr::platform::readFile(path("a.txt"), 99);
    EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "before within after");
    EXPECT_THROW(cdr::platform::writeText("/dev/fd/" + std::to_string(file), "closed"), InputError);
}

TEST_F(FileTest, KeepsTheModeOfTheFileItReplaces) {
    cdr::platform::writeFile(path("a.bin"), Bytes{1});
    fs::permissions(path("a.bin"), fs::perms::owner_read | fs::perms::owner_write);
    cdr::platform::writeFile(path("a.bin"), Bytes{2});
    EXPECT_EQ(fs::status(path("a.bin")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

/// Nobody can plant a link under a name that they cannot foresee, and the file exists before it is written.
TEST_F(FileTest, TemporaryNamesAreRandomAndTaken) {
    std::set<fs::path> names;
    for (int i = 0; i < 50; ++i) {
        const cdr::platform::PendingFile file(path("a.png"));
        EXPECT_EQ(file.temporary().extension(), ".png");
        EXPECT_EQ(file.temporary().parent_path(), path("a.png").parent_path());
        EXPECT_TRUE(fs::is_regular_file(file.temporary()));
        EXPECT_EQ(file.temporary().string().find(std::to_string(::getpid()) + "."), std::string::npos);
        names.insert(file.temporary());
    }
    EXPECT_EQ(names.size(), 50u);
    EXPECT_EQ(filesInFolder(), 0u);
}

/// The name while it is written is longer than the extension alone.
TEST_F(FileTest, WritesUnderTheLongestExtension) {
    const fs::path file = path(("x." + std::string(240, 'y')).c_str());
    cdr::platform::writeText(file, "whole");
    EXPECT_EQ(fs::file_size(file), 5u);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, RefusesNamesThatAreTooLong) {
    EXPECT_THROW(cdr::platform::requireWritable(path(std::string(300, 'x').c_str())), InputError);
}

/// A pipe does not block where a program that shares it made it so.
TEST_F(FileTest, WaitsForRoomInAPipe) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    std::size_t read = 0;
    std::thread reader([&] {
        ::pollfd room{.fd = ends[1], .events = POLLOUT, .revents = 0};
        while (::poll(&room, 1, 0) == 1 && room.revents == POLLOUT) { // until the pipe is full, or closed
            std::this_thread::yield();
        }
        std::array<char, 4096> some{};
        for (ssize_t got = 1; got > 0; read += static_cast<std::size_t>(got)) {
            got = ::read(ends[0], some.data(), some.size());
        }
    });
    constexpr std::size_t kMoreThanAPipeHolds = std::size_t{1} << 22;
    EXPECT_NO_THROW(cdr::platform::writeText("/dev/fd/" + std::to_string(ends[1]),
                                             std::string(kMoreThanAPipeHolds, 'x')));
    ::close(ends[1]);
    reader.join();
    ::close(ends[0]);
    EXPECT_EQ(read, kMoreThanAPipeHolds);
}

TEST(Document, KeepsTextThatIsNotUtf8) {
    const auto json = nlohmann::ordered_json::parse(cdr::platform::textOf({{"scene", "a\xff.glb"}}, 2));
    EXPECT_EQ(json.at("scene"), "a\xEF\xBF\xBD.glb");
}

TEST(EnumNames, ReadInBothDirections) {
    enum class Colour : std::uint8_t { red, green };
    constexpr cdr::base::EnumNames<Colour, 2> kColours{"colour", {"red", "green"}};
    static_assert(kColours.nameOf(Colour::green) == "green");
    EXPECT_EQ(kColours.parse("green"), Colour::green);
    EXPECT_EQ(cdr::test::inputErrorOf([&] { kColours.parse("gren"); }),
              "unknown colour 'gren'; did you mean 'green'? (known: red, green)");
}

TEST(ParseNumber, TakesFiniteNumbersOnly) {
    EXPECT_EQ(cdr::base::parseNumber("near", "1e-3"), 1e-3);
    for (const char* bad : {"", "nan", "inf", "-inf", "1x", " 1", "1e999"}) {
        EXPECT_THROW(cdr::base::parseNumber("near", bad), InputError) << bad;
    }
}

} // namespace
