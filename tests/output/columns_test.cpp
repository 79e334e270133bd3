#include <gtest/gtest.h>
#include <output/columns.h>
#include <output/wrong_pixels_columns.h>

#include <cmath>

namespace {

using namespace cdr;
using namespace cdr::output;

struct Row {
    std::string name;
    double share = 0.0;
    std::optional<double> bound;
    measure::WrongPixels wrong;

    double twice() const { return 2.0 * share; }
};

const Columns<Row>& columns() {
    static const Columns<Row> kColumns{
        {.key = "name", .value = &Row::name, .heading = "who"},
        {.key = "twice", .value = &Row::twice},
        {.key = "share", .value = &Row::share, .heading = "share", .format = {"{} %", 100.0}},
        {.key = "bound",
         .value = &Row::bound,
         .heading = "bound",
         .format = {.missing = "never"},
         .before = "share"},
        {.key = "left_out", .value = [](const Row&) { return absent(); }},
        {.value =
             [](const Row& row) {
                 return jsonOf(measure::Interval{row.share, row.twice()});
             },
         .heading = "interval",
         .format = {"{:+} to {:+}"}}};
    return kColumns;
}

const std::vector<Row> kRows{{.name = "a", .share = 0.25, .bound = 3.0, .wrong = {}},
                             {.name = "b", .share = 0.5, .bound = INFINITY, .wrong = {}}};

TEST(Columns, OneListMakesJsonAndTheTable) {
    EXPECT_EQ(jsonOf(columns(), kRows).dump(), R"([{"name":"a","twice":0.5,"share":0.25,"bound":3.0},)"
                                               R"({"name":"b","twice":1.0,"share":0.5,"bound":null}])");
    const Table table = tableOf(columns(), kRows);
    EXPECT_EQ(table.header, (std::vector<std::string>{"who", "bound", "share", "interval"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"a", "3", "25 %", "+0.25 to +0.5"},
                                                                 {"b", "never", "50 %", "+0.5 to +1"}}));
}

TEST(Columns, OfAPartStandAmongTheRowsOwn) {
    const Columns<Row> all = joined<Row>(
        {{{.key = "name", .value = &Row::name, .heading = "name"}},
         columnsOf(&Row::wrong, wrongPixelsColumns({.wrong = "wrong", .share = "share of all"}))});
    const std::vector<Row> rows{{.name = "a", .bound = {}, .wrong = {.pixels = 8, .wrong = 1}}};
    EXPECT_EQ(jsonOf(all, rows.front()).dump(),
              R"({"name":"a","pixels":8,"wrong":1,"wrong_fraction":0.125,"overlap_pixels":0,)"
              R"("overlap_wrong":0,"overlap_wrong_fraction":null,"edge_wrong":0})");
    EXPECT_EQ(tableOf(all, rows).rows.front(), (std::vector<std::string>{"a", "1", "12.5 %"}));
    EXPECT_EQ(jsonOf(all, kRows.front()).at("wrong_fraction"), nullptr) << "a share of nothing";
    EXPECT_EQ(tableOf(all, kRows).rows.front(), (std::vector<std::string>{"a", "0", ""}));
}

TEST(Columns, OfAPartThatARowLacksAreAbsent) {
    const Columns<double> ofBound{{.key = "bound",
                                   .value = [](double bound) { return bound; },
                                   .heading = "bound",
                                   .text = [](double) { return "told"; },
                                   .before = "name"}};
    const Columns<Row> all = joined<Row>(
        {{{.key = "name", .value = &Row::name, .heading = "name"}}, columnsOf<Row>(&Row::bound, ofBound)});
    const std::vector<Row> rows{{.name = "a", .bound = 3.0, .wrong = {}},
                                {.name = "b", .bound = {}, .wrong = {}}};
    EXPECT_EQ(jsonOf(all, rows).dump(), R"([{"name":"a","bound":3.0},{"name":"b"}])");
    EXPECT_EQ(tableOf(all, rows).rows, (std::vector<std::vector<std::string>>{{"told", "a"}, {"", "b"}}));
}

TEST(Columns, CsvReadsTheJson) {
    const Json rows = Json::parse(R"([{"a":1,"b":[0.5,null],"c":true,"d":"x"}])");
    EXPECT_EQ(csvOf({"a", "low=/b/0", "high=/b/1", "c", "d"}, rows), "a,low,high,c,d\n1,0.5,,true,x\n");
    EXPECT_EQ(csvOf({"d", "a"}, rows), "d,a\nx,1\n");
    EXPECT_EQ(csvOf({"a", "low=/b/0", "high=/b/1"}, Json::parse(R"([{"a":1,"b":null}])")),
              "a,low,high\n1,,\n");
    EXPECT_ANY_THROW(csvOf({"c"}, Json::parse(R"([{"a":1}])"))) << "a field that no row has";
}

} // namespace
