#include "../cli/program.h"

#include <report/plan.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

namespace cdr::report_test {

namespace {

using cli_test::ProgramResult;
using cli_test::readText;
using cli_test::runProgram;
using cli_test::succeed;
using test::TemporaryFolder;

namespace fs = std::filesystem;
using nlohmann::json;

/// Where npm's packages were missing at build time, `cdr report` has no page; it then says so and does
/// nothing.
bool hasPage() {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "x";
    return runProgram("report --smallest -o file", folder.path()).status == 2;
}

class ReportCommand : public testing::Test {
  protected:
    void SetUp() override {
        if (!hasPage()) {
            GTEST_SKIP() << "built without the report's page: tools/setup.sh fetches its npm packages";
        }
    }

    ProgramResult report(const std::string& arguments) const {
        return runProgram("report --smallest " + arguments, m_folder.path());
    }
    /// Copies the report that the test Report.Made wrote, so that each test need not wait for its own.
    void copyReport() const {
        ASSERT_TRUE(fs::exists(CDR_REPORT "/made"))
            << "run the tests through CTest: it makes the report first";
        fs::copy(CDR_REPORT, m_folder.path(), fs::copy_options::recursive);
    }
    fs::path path(const std::string& name) const { return m_folder.path() / name; }
    std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : fs::directory_iterator(m_folder.path())) {
            found.insert(entry.path().filename().string());
        }
        return found;
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  private:
    TemporaryFolder m_folder;
};

TEST_F(ReportCommand, WritesOneFolderThatHoldsAllOfItsFiles) {
    copyReport();
    EXPECT_EQ(names(), (std::set<std::string>{"made", "manifest.json"}));
    const json manifest = json::parse(readText(path("made/report.json")));
    EXPECT_EQ(manifest, json::parse(readText(path("manifest.json"))));
    EXPECT_EQ(manifest.at("command"), "report");
    EXPECT_EQ(manifest.at("options").at("effort"), "smallest");
    std::set<std::string> sections;
    for (const json& row : manifest.at("results")) {
        sections.insert(row.at("section"));
        EXPECT_TRUE(row.at("failure").is_null()) << row;
        EXPECT_TRUE(fs::is_regular_file(path("made") / row.at("json").get<std::string>())) << row;
        EXPECT_EQ(row.at("command").get<std::string>().find("/tmp"), std::string::npos) << row;
    }
    std::set<std::string> planned;
    for (const report::Section& section : report::makePlan({})) {
        planned.insert(section.name);
    }
    EXPECT_EQ(sections, planned);
    EXPECT_EQ(planned.size(), 34u);
    for (const char* file : {"index.html", "compare.html", "data.js", "LICENSES.txt"}) {
        const json& files = manifest.at("files");
        EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
    }
}

/// What the page says to be after repair is counted by rays of its own, and the certificate lies beside it.
TEST_F(ReportCommand, HoldsCertificatesOfFramesThatRaysFindRight) {
    copyReport();
    std::size_t certificates = 0;
    for (const auto& entry : fs::directory_iterator(path("made/data"))) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("certificates-")) {
            continue;
        }
        ++certificates;
        const json measured = json::parse(readText(entry.path()));
        const json certificate =
            json::parse(readText(path("made/data") / ("certificate-" + name.substr(name.find('-') + 1))));
        ASSERT_EQ(measured.at("results").size(), certificate.at("results").size()) << name;
        for (std::size_t i = 0; i < measured.at("results").size(); ++i) {
            const json& row = measured["results"][i];
            EXPECT_EQ(row.at("wrong").get<int>() + row.at("edge_wrong").get<int>(), 0) << name << row;
            EXPECT_EQ(row.at("certified"), certificate["results"][i].at("certified")) << name;
        }
    }
    EXPECT_EQ(certificates, 9u);
}

/// The name of a device up to and with its first space.
std::string nameWithASpace(const json& devices) {
    for (const json& device : devices) {
        const std::string name = device.at("name");
        if (const std::size_t space = name.find(' '); space != std::string::npos) {
            return name.substr(0, space + 1);
        }
    }
    return "";
}

TEST_F(ReportCommand, ReplacesAnOlderReportWholeAndQuotesItsDevice) {
    copyReport();
    fs::remove(path("made/index.html"));
    fs::remove(path("manifest.json"));
    const ProgramResult devices = succeed("devices --json", path("."));
    const std::string device = nameWithASpace(json::parse(devices.out).at("results"));
    const std::string option = device.empty() ? "" : "--device '" + device + "' ";
    // A slash more names the same folder. Lines come as sections end: two are there before the page is.
    const ProgramResult again = report(
        option +
        "--sections precision,flicker,probe -o made/ | { read all; read one; test -e made/index.html || echo early; cat; } > lines; "
        "{ cat lines; rm lines; }");
    ASSERT_TRUE(fs::exists(path("made/index.html"))) << again.err;
    EXPECT_EQ(again.out.find("early\n"), 0u) << again.out;
    EXPECT_EQ(names(), std::set<std::string>{"made"});
    const json manifest = json::parse(readText(path("made/report.json")));
    EXPECT_EQ(manifest.at("results").at(0).at("command"),
              "cdr " + option + "precision --json data/precision.json");
}

TEST_F(ReportCommand, LeavesAFolderThatIsNoReportAlone) {
    fs::create_directory(path("thesis"));
    write("thesis/chapter.txt", "years of work");
    expectOneLine(report("-o thesis"), 2, "nor a report");
    EXPECT_EQ(readText(path("thesis/chapter.txt")), "years of work");
    EXPECT_EQ(names(), std::set<std::string>{"thesis"});
}

TEST_F(ReportCommand, LeavesAReportAloneThatHoldsMoreThanItsOwnFiles) {
    copyReport();
    write("made/answers.csv", "of twelve people");
    expectOneLine(report("-o made"), 2, "answers.csv");
    EXPECT_TRUE(fs::exists(path("made/answers.csv")));
}

TEST_F(ReportCommand, TrustsNoManifest) {
    fs::create_directory(path("odd"));
    for (const char* manifest :
         {"", "[]", "{}", R"({"command":"report"})", R"({"command":"report","files":7})",
          R"({"command":["report"],"files":[]})", R"({"command":"timing","files":[]})"}) {
        write("odd/report.json", manifest);
        EXPECT_EQ(report("-o odd").status, 2) << manifest;
        EXPECT_EQ(readText(path("odd/report.json")), manifest);
    }
}

TEST_F(ReportCommand, LeavesNothingBehindWhenItCannotRun) {
    fs::create_directory(path("empty"));
    write("file", "x");
    for (const char* arguments : {"-o file", "-o missing/report", "-o /", "--quick", "--full", "--threads 0",
                                  "--sections nosuch -o empty", "--device nobody-has-this -o empty",
                                  "--json missing/x.json -o empty", "--json empty/x.json -o empty"}) {
        SCOPED_TRACE(arguments);
        expectOneLine(report(arguments), 2);
    }
    EXPECT_EQ(names(), (std::set<std::string>{"empty", "file"}));
    EXPECT_TRUE(fs::is_empty(path("empty")));
}

} // namespace

} // namespace cdr::report_test
