#include <gtest/gtest.h>
#include <output/columns.h>
#include <runs/shallow_cbor.h>

#include <limits>
#include <string>
#include <vector>

namespace cdr::runs {
namespace {

using output::Json;

TEST(ShallowCbor, HoldsWhatResultsAre) {
    const Json all{{"numbers",
                    {0, 23, 24, 255, 256, 65536, 1LL << 40, -1, -25, -70000, 0.5, 1e300,
                     std::numeric_limits<double>::infinity()}},
                   {"text", std::string(70000, 'x')},
                   {"none", nullptr},
                   {"is", true},
                   {"bytes", Json::binary(std::vector<std::uint8_t>(300, 7))},
                   {"empty", {Json::array(), Json::object(), ""}}};
    for (const Json& json : {all, Json(7), Json("text"), Json(std::vector<Json>(300, all))}) {
        const platform::Bytes bytes = Json::to_cbor(json);
        EXPECT_TRUE(isShallowCbor(bytes));
        EXPECT_EQ(Json::from_cbor(bytes), json);
        EXPECT_FALSE(isShallowCbor({bytes.begin(), bytes.end() - 1}));
        platform::Bytes longer = bytes;
        longer.push_back(0);
        EXPECT_FALSE(isShallowCbor(longer));
    }
}

TEST(ShallowCbor, HoldsNothingDeep) {
    for (const std::size_t depth : {98u, 99u, 100u}) {
        platform::Bytes bytes(depth, 0x81);
        bytes.push_back(0);
        EXPECT_EQ(isShallowCbor(bytes), depth < 100) << depth;
    }
    for (const std::uint8_t open : platform::Bytes{0x5f, 0x7f, 0x9f, 0xbf, 0xc0, 0xd8}) {
        EXPECT_FALSE(isShallowCbor({open, 0x00, 0xff})) << int{open};
    }
}

TEST(ShallowCbor, LengthsEndWithTheBytes) {
    for (const std::uint8_t head : platform::Bytes{0x5b, 0x7b, 0x9b, 0xbb}) {
        EXPECT_FALSE(isShallowCbor({head, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0, 0}))
            << int{head};
        EXPECT_FALSE(isShallowCbor({head, 0x80, 0, 0, 0, 0, 0, 0, 0})) << int{head};
    }
}

} // namespace
} // namespace cdr::runs
