#include "../support/refusal.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>

#include <gtest/gtest.h>
#include <output/gnuplot.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cdr::output;
using cdr::base::InputError;
using cdr::base::RunError;

class GnuplotTest : public testing::Test {
  protected:
    const fs::path& folder() const { return m_folder.path(); }
    bool isMissing() const { return std::system("gnuplot --version >/dev/null 2>&1") != 0; }

  private:
    cdr::test::TemporaryFolder m_folder;
};

std::string beginOf(const fs::path& path, std::size_t bytes) {
    std::string text(bytes, '\0');
    std::ifstream(path, std::ios::binary).read(text.data(), static_cast<std::streamsize>(bytes));
    return text;
}

TEST_F(GnuplotTest, WritesPngAndSvg) {
    if (isMissing()) {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    writePlot(folder() / "it's a plot.png", "plot x title " + gnuplotQuote("a 'quoted' name") + "\n");
    EXPECT_EQ(beginOf(folder() / "it's a plot.png", 4), "\x89PNG");
    writePlot(folder() / "p.svg", "plot x\n");
    EXPECT_EQ(beginOf(folder() / "p.svg", 5), "<?xml");
    EXPECT_NO_THROW(requirePlottable(folder() / "Q.PNG"));
    writePlot(folder() / "Q.PNG", "plot x\n");
    EXPECT_EQ(beginOf(folder() / "Q.PNG", 4), "\x89PNG");
}

TEST_F(GnuplotTest, ABadScriptIsReportedAndLeavesNothing) {
    if (isMissing()) {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    try {
        writePlot(folder() / "p.png", "plot nonsense(x)\n");
        FAIL() << "nothing was thrown";
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(GnuplotTest, OtherFormatsAreRefused) {
    EXPECT_THROW(requirePlottable(folder() / "p.pdf"), InputError);
    EXPECT_THROW(requirePlottable(folder() / "p"), InputError);
    EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(GnuplotTest, AMissingGnuplotIsNamed) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", folder().c_str(), 1);
    const std::string message = cdr::test::inputErrorOf([&] { requirePlottable(folder() / "p.png"); });
    EXPECT_NE(message.find("gnuplot-nox"), std::string::npos) << message;
    ::setenv("PATH", path.c_str(), 1);
}

/// What gnuplot does on a full disk: it ends with status 0.
TEST_F(GnuplotTest, AFileThatIsCutIsNotKept) {
    const std::string path = std::getenv("PATH");
    std::ofstream(folder() / "gnuplot") << "#!/bin/sh\ncat >/dev/null\nprintf '\\211PNG\\r\\n'\n";
    fs::permissions(folder() / "gnuplot", fs::perms::owner_all);
    ::setenv("PATH", (folder().string() + ":" + path).c_str(), 1);
    for (const char* name : {"p.png", "p.svg"}) {
        const std::string message = cdr::test::runErrorOf([&] { writePlot(folder() / name, "plot x\n"); });
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_NE(message.find("the disk may be full"), std::string::npos);
        EXPECT_FALSE(fs::exists(folder() / name));
    }
    ::setenv("PATH", path.c_str(), 1);
}

TEST(GnuplotQuote, KeepsTextInItsQuotes) {
    EXPECT_EQ(gnuplotQuote("plain"), "'plain'");
    EXPECT_EQ(gnuplotQuote("it's"), "'it''s'");
    EXPECT_EQ(gnuplotQuote("two\nlines"), "'two lines'");
}

} // namespace
