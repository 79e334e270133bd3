#include <report/manifest.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cdr::report_test {

namespace {

using report::filesOfManifest;

/// A report's manifest with one member more.
std::string manifestWith(const std::string& value) {
    return R"({"command":"report","more":)" + value + R"(,"files":["data/a.json"]})";
}

std::string nested(int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
}

TEST(Manifest, ListsTheFilesOfAReportAndItself) {
    EXPECT_EQ(filesOfManifest(manifestWith("1")), (std::set<std::string>{"data/a.json", report::kManifest}));
    EXPECT_EQ(filesOfManifest(R"({"files":[1,["b"],"c"],"command":"report"})"),
              (std::set<std::string>{"c", report::kManifest}));
}

TEST(Manifest, IsNoneOfAnotherCommandOrShape) {
    for (const char* text :
         {"", "[]", "{}", "report", R"({"command":"report"})", R"({"command":"report","files":{}})",
          R"({"command":"render","files":[]})", R"({"command":["report"],"files":[]})",
          R"({"command":"report","files":[]} {})"}) {
        EXPECT_FALSE(filesOfManifest(text)) << text;
    }
}

TEST(Manifest, IsNotNestedDeeply) {
    EXPECT_TRUE(filesOfManifest(manifestWith(nested(8))));
    EXPECT_FALSE(filesOfManifest(manifestWith(nested(40))));
    EXPECT_FALSE(filesOfManifest(manifestWith(nested(1'000'000))));
}

} // namespace

} // namespace cdr::report_test
