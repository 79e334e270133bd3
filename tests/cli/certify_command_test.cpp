#include "../support/fault.h"
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using CertifyCommand = FolderTest;

constexpr const char* kCertify = "render afc --technique anchored --size 320x180 --certify c.json ";

TEST_F(CertifyCommand, WritesPicturesThatAreRightAndTheirCertificate) {
    succeed(std::string(kCertify) + "--frames 2 --aov wrong --json a.json -o p%04d.png");
    EXPECT_TRUE(std::filesystem::exists(at("p0001.png")));
    const json rows = jsonIn("a.json").at("results");
    const json certificate = jsonIn("c.json");
    EXPECT_EQ(certificate.at("command"), "render");
    EXPECT_EQ(certificate.at("device").at("name"), deviceInfo().name);
    EXPECT_EQ(certificate.at("sub_pixel_bits"), deviceInfo().subPixelBits);
    EXPECT_EQ(certificate.at("options").at("mapping"), "anchored");
    ASSERT_EQ(certificate.at("results").size(), 2u);
    // Cast is what snapped outlines pass over, so the device's bits say how much. With 4 and with 8 it is 0.3 to 0.5 of this
    // share.
    const double mostCast = std::ldexp(1.0, -2 - static_cast<int>(deviceInfo().subPixelBits));
    for (std::size_t i = 0; i < 2; ++i) {
        const json& frame = certificate.at("results")[i];
        EXPECT_EQ(frame.at("frame"), i);
        EXPECT_EQ(frame.at("pixels"), 320 * 180);
        EXPECT_EQ(frame.at("certified").get<int>() + frame.at("cast").get<int>(), 320 * 180);
        EXPECT_GT(frame.at("proven").get<int>(), 0);
        EXPECT_LT(frame.at("proven").get<int>(), frame.at("certified").get<int>() / 10);
        EXPECT_GT(frame.at("certified_fraction"), 1.0 - mostCast);
        EXPECT_EQ(frame.at("refused"), 0);
        EXPECT_GE(frame.at("repaired"), frame.at("wrong_before"));
        EXPECT_EQ(frame.at("hash"), rows[i].at("hash"));
        const json& bound = frame.at("bound");
        EXPECT_GT(bound.at("pixels"), frame.at("snap_pixels")) << "half a sub-pixel, and roundings";
        EXPECT_LT(bound.at("pixels"), frame.at("snap_pixels").get<double>() + 0.01);
        EXPECT_GT(bound.at("distance"), 0.0);
        EXPECT_GT(bound.at("depth"), 0.0);
        EXPECT_GT(bound.at("depth_step"), 0.0);
        EXPECT_EQ(frame.at("camera").at("eye").size(), 3u);
        EXPECT_EQ(rows[i].at("cast"), frame.at("cast"));
        EXPECT_EQ(rows[i].at("wrong"), 0);
        EXPECT_EQ(rows[i].at("edge_wrong"), 0);
    }
    EXPECT_GT(certificate.at("results")[0].at("wrong_before"), 0) << "edges that float64 decides otherwise";
}

/// The garden with all that is blended made masked, in as many bytes.
TEST_F(CertifyCommand, ProvesWhatAMaskDecides) {
    std::string model = readText(CDR_SOURCE_DIR "/tests/assets/garden.glb");
    const std::string blended = R"("alphaMode":"BLEND")";
    for (std::size_t at = model.find(blended); at != std::string::npos; at = model.find(blended, at)) {
        model.replace(at, blended.size(), R"("alphaMode":"MASK" )");
    }
    std::ofstream(at("masked.glb"), std::ios::binary) << model;
    const json row = documentOf(
        "render masked.glb --technique anchored --size 320x180 --certify c.json --aov wrong")["results"][0];
    const json frame = jsonIn("c.json").at("results")[0];
    EXPECT_GT(frame.at("proven").get<int>(), 320 * 180 / 100);
    EXPECT_LE(frame.at("cast_masked"), frame.at("cast"));
    EXPECT_EQ(frame.at("certified").get<int>() + frame.at("cast").get<int>(), 320 * 180);
    EXPECT_EQ(frame.at("refused"), 0);
    EXPECT_EQ(row.at("wrong"), 0);
    EXPECT_EQ(row.at("edge_wrong"), 0);
}

/// A driver that draws an eighth of a pixel beside the place.
TEST_F(CertifyCommand, EndsWithStatus3WhereADriverKeepsNotToItsLimits) {
    const test::Fault beside{.call = "vkCmdSetViewport", .times = test::kForever, .result = 2};
    expectOneLine(run("--quiet " + std::string(kCertify) + "-o p.png", beside.environment()), 3,
                  "frame 0 refused: ");
    EXPECT_FALSE(std::filesystem::exists(at("p.png")));
    const json frame = jsonIn("c.json").at("results")[0];
    EXPECT_GT(frame.at("refused"), 0);
    EXPECT_EQ(frame.at("first_refused").size(), 2u);
    EXPECT_FALSE(frame.contains("hash"));
}

/// No ray is cast for a frame that is refused: what rays would have found is not known.
TEST_F(CertifyCommand, CountsNoRaysOfARefusedFrame) {
    const test::Fault beside{.call = "vkCmdSetViewport", .times = test::kForever, .result = 2};
    const ProgramResult result = run(std::string(kCertify) + "--json a.json -o p.png", beside.environment());
    ASSERT_EQ(result.status, 3) << result.err;
    EXPECT_TRUE(std::regex_search(result.out, std::regex(" +- +- +- +[0-9.]+ *\n"))) << result.out;
    for (const char* name : {"a.json", "c.json"}) {
        const json frame = jsonIn(name).at("results")[0];
        ASSERT_GT(frame.at("refused"), 0) << name;
        for (const char* field : {"cast", "cast_masked", "wrong_before", "repaired"}) {
            EXPECT_TRUE(frame.at(field).is_null()) << name << " " << field;
        }
    }
}

} // namespace

} // namespace cdr::cli_test
