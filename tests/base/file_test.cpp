#include <cdr/base/error.h>
#include <cdr/base/file.h>
#include <cdr/base/sha256.h>
#include <cdr/base/suggest.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;
using cdr::base::Bytes;
using cdr::base::InputError;

class FileTest : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(m_folder); }
    void TearDown() override { fs::remove_all(m_folder); }
    fs::path path(const char* name) const { return m_folder / name; }
    std::size_t filesInFolder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }

  private:
    fs::path m_folder = fs::path(testing::TempDir()) / ("cdr_file_test_" + std::to_string(::getpid()));
};

TEST_F(FileTest, WritesAndReadsBack) {
    const Bytes bytes{1, 2, 3, 0, 255};
    cdr::base::writeFile(path("a.bin"), bytes);
    EXPECT_EQ(cdr::base::readFile(path("a.bin"), 5), bytes);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, RefusesMissingFoldersAndTooLargeFiles) {
    cdr::base::writeFile(path("a.bin"), Bytes(10));
    EXPECT_THROW(cdr::base::readFile(path("a.bin"), 9), InputError);
    EXPECT_THROW(cdr::base::readFile(path("b.bin"), 9), InputError);
    EXPECT_THROW(cdr::base::readFile(path(""), 9), InputError);
    EXPECT_THROW(cdr::base::readFile("/dev/zero", 9), InputError);
}

TEST_F(FileTest, AFailedWriteLeavesTheOldFileAndNothingElse) {
    cdr::base::writeFile(path("a.bin"), Bytes{7});
    EXPECT_THROW(cdr::base::writeBesideThenRename(path("a.bin"),
                                                  [](const fs::path& temporary) {
                                                      std::ofstream(temporary) << "half";
                                                      throw std::runtime_error("midway");
                                                  }),
                 std::runtime_error);
    EXPECT_EQ(cdr::base::readFile(path("a.bin"), 9), Bytes{7});
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, TellsWhetherAPathCanBeWritten) {
    EXPECT_NO_THROW(cdr::base::requireWritable(path("new.png")));
    EXPECT_EQ(filesInFolder(), 0u);
    EXPECT_THROW(cdr::base::requireWritable(path("no/such/folder.png")), InputError);
    EXPECT_THROW(cdr::base::requireWritable(path(".")), InputError);
    EXPECT_THROW(cdr::base::writeFile(path("no/such/folder.png"), Bytes{1}), InputError);
}

TEST(Sha256, MatchesPublishedVectors) {
    // FIPS 180-4 example and the empty message.
    const std::string abc = "abc";
    EXPECT_EQ(cdr::base::sha256Of(abc), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(cdr::base::sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(UnknownName, SuggestsTheClosest) {
    constexpr std::array<std::string_view, 3> kKnown{"standard", "reversed", "log"};
    EXPECT_NE(cdr::base::unknownName("technique", "reversd", kKnown).find("did you mean 'reversed'"),
              std::string::npos);
    EXPECT_EQ(cdr::base::unknownName("technique", "zzzzzzzzzzzzz", kKnown).find("did you mean"),
              std::string::npos);
    EXPECT_LT(cdr::base::unknownName("technique", std::string(100000, 'x'), kKnown).size(), 200u);
}

TEST(ParseNumber, TakesFiniteNumbersOnly) {
    EXPECT_EQ(cdr::base::parseNumber("near", "1e-3"), 1e-3);
    for (const char* bad : {"", "nan", "inf", "-inf", "1x", " 1", "1e999"}) {
        EXPECT_THROW(cdr::base::parseNumber("near", bad), InputError) << bad;
    }
}

} // namespace
