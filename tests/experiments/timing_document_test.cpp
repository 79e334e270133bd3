#include "../support/refusal.h"

#include <experiments/timing/timing_document.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace cdr::experiments {
namespace {

using nlohmann::json;

json timingOfTwo() {
    return {{"commit", "abc"},
            {"device", {{"name", "llvmpipe"}, {"driver", "Mesa"}}},
            {"results",
             {{{"mode", "standard"}, {"name", "standard"}, {"median_us", 1000}},
              {{"mode", "log"}, {"median_us", 1000.5}}}}};
}

std::string timingRefusal(const std::string& text) {
    return test::inputErrorOf([&] { readTimingDocument(text, "other"); });
}

TEST(TimingDocument, HoldsModesAndDevice) {
    const TimingDocument document = readTimingDocument(timingOfTwo().dump(), "other");
    EXPECT_EQ(document.commit, "abc");
    EXPECT_EQ(document.device, "llvmpipe");
    EXPECT_EQ(document.driver, "Mesa");
    ASSERT_EQ(document.medianUs.size(), 2u);
    EXPECT_EQ(document.medianUs[0], std::pair(std::string("standard"), 1000.0));
    EXPECT_EQ(document.medianUs[1], std::pair(std::string("log"), 1000.5));
    json silent = timingOfTwo();
    silent.erase("commit");
    silent["device"] = json::object();
    EXPECT_EQ(readTimingDocument(silent.dump(), "other").commit, "unknown");
}

TEST(TimingDocument, IsRefusedInOneLineWhereItIsNone) {
    for (const char* text : {"", "{", "7", "[]", "null", "{}", R"({"results": []})", R"({"device": {}})"}) {
        EXPECT_EQ(timingRefusal(text), "other wrote no timing results") << text;
    }
}

/// Each value that is read, of each other type and out of its range.
TEST(TimingDocument, IsRefusedInOneLineWhereAValueIsAnother) {
    const json strange{
        nullptr, true, -1, 0, 1e300, "a\nb", "", json::array(), json::object(), std::string(300, 'a')};
    for (const char* place : {"/device", "/results", "/results/0", "/results/1/median_us"}) {
        for (const json& value : strange) {
            if (std::string(place) == "/results/1/median_us" && value == 1e300) {
                continue;
            }
            json document = timingOfTwo();
            document[json::json_pointer(place)] = value;
            if (std::string(place) == "/device" && value == json::object()) {
                continue;
            }
            const std::string refusal = timingRefusal(document.dump());
            EXPECT_TRUE(refusal.starts_with("other wrote timing results that cannot be used: "))
                << place << value;
            EXPECT_EQ(std::count(refusal.begin(), refusal.end(), '\n'), 0) << place << value;
        }
    }
    for (const char* place :
         {"/commit", "/device/name", "/device/driver", "/results/0/name", "/results/1/mode"}) {
        for (const json& value : strange) {
            if (value == "") {
                continue; // a text, though no name of a mode
            }
            json document = timingOfTwo();
            document[json::json_pointer(place)] = value;
            EXPECT_NE(timingRefusal(document.dump()), "") << place << value;
        }
    }
}

TEST(TimingDocument, IsBounded) {
    EXPECT_NE(timingRefusal(std::string(kMaxTimingBytes, ' ') + timingOfTwo().dump()).find("MiB"),
              std::string::npos);
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_NE(timingRefusal(R"({"device": )" + deep + R"(, "results": []})").find("too deep"),
              std::string::npos);
    json many = timingOfTwo();
    many["results"] = json::array();
    for (std::size_t row = 0; row <= kMaxTimingRows; ++row) {
        many["results"].push_back({{"name", "log"}, {"median_us", 1}});
    }
    EXPECT_NE(timingRefusal(many.dump()).find("list"), std::string::npos);
    many["results"].erase(0);
    EXPECT_EQ(timingRefusal(many.dump()), "");
}

} // namespace
} // namespace cdr::experiments
