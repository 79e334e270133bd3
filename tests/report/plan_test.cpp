#include <cdr/base/error.h>
#include <report/plan.h>
#include <report/plan_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cdr::report_test {

namespace {

using namespace cdr::report;

std::string lineOf(const PlanOptions& options, const std::string& name) {
    const std::vector<Section> plan = makePlan(options);
    const auto section = std::ranges::find_if(plan, [&](const Section& each) { return each.name == name; });
    return section != plan.end() ? commandLine(*section, "") : "";
}

TEST(Plan, EveryOptionHasAValueForEveryEffort) {
    std::set<std::string> names;
    for (const PlanRow& row : planTable()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_LE(row.seconds.quick, row.seconds.full) << row.name;
        for (const PlanOption& option : row.options) {
            const std::size_t values = option.values.size();
            EXPECT_TRUE(values == 0 || values == 1 || values == 3) << row.name << " " << option.name;
        }
    }
}

TEST(Plan, CommandsDifferByEffort) {
    EXPECT_EQ(
        lineOf({.effort = Effort::smallest, .threads = 2, .seed = 7}, "flicker"),
        "cdr flicker --frames 4 --size 160x90 --flip-every 2 --moved --fitted-range --threads 2 --seed 7 "
        "--videos videos --json data/flicker.json");
    EXPECT_EQ(lineOf({.effort = Effort::full, .videos = false}, "flicker"),
              "cdr flicker --frames 360 --size 1280x720 --flip-every 1 --moved --fitted-range --threads 1 "
              "--seed 2013 --json data/flicker.json");
    EXPECT_EQ(
        lineOf({.effort = Effort::smallest}, "timing"),
        "cdr timing --frames 2 --size 64x36 --modes cdr-2,cdr-5,log,logcdr-5,reversed,anchored --threads 1 "
        "--seed 2013 --json data/timing.json");
    EXPECT_EQ(lineOf({}, "scaling"), "cdr scaling --draws 1000,20000 --cascades 1,4 --repeats 5 --seed 2013 "
                                     "--json data/scaling.json");
    EXPECT_EQ(lineOf({}, "detail"), "cdr detail boulders --frames 6 --size 1280x720 --threads 1 --seed 2013 "
                                    "--out detail --json data/detail.json");
    EXPECT_EQ(lineOf({}, "precision"), "cdr precision --json data/precision.json");
}

/// A number of JavaScript has 53 bits, so the page takes the seed as text.
TEST(Plan, TheCommandOfTheWholeReportHasWhatItWasMadeWith) {
    EXPECT_EQ(commandLine(PlanOptions{.threads = 4}, ""), "cdr report --quick --threads 4 --seed 2013 -o .");
    EXPECT_EQ(commandLine(PlanOptions{.effort = Effort::full,
                                      .seed = 18446744073709551615u,
                                      .sections = {"probe", "detail"}},
                          "John's GPU"),
              "cdr --device 'John'\\''s GPU' report --full --sections probe,detail --threads 1 --seed "
              "18446744073709551615 -o .");
}

/// A row for each scene; the page shows the pictures of one.
TEST(Plan, ShadowsAndCertificatesAreOfEachScene) {
    EXPECT_EQ(lineOf({}, "shadows-alley"),
              "cdr shadows alley --methods plain,anchored --frames 3 --size 640x360 --threads 1 --seed 2013 "
              "--json data/shadows-alley.json");
    EXPECT_EQ(lineOf({.effort = Effort::full}, "shadows-orbit"),
              "cdr shadows orbit --methods plain,anchored --frames 8 --size 1280x720 --threads 1 --seed 2013 "
              "--out shadows --json data/shadows-orbit.json");
    EXPECT_EQ(lineOf({}, "certificates-orbit-standard"),
              "cdr render orbit --technique standard --aov wrong --frames 5 --size 640x360 --threads 1 "
              "--seed 2013 --certify data/certificate-orbit-standard.json "
              "--json data/certificates-orbit-standard.json");
    const std::vector<Section> plan = makePlan({});
    const auto countOf = [&](const std::string& part) {
        return std::ranges::count_if(
            plan, [&](const Section& each) { return each.name.starts_with(part) && each.isTimed; });
    };
    EXPECT_EQ(countOf("shadows-"), 4);
    EXPECT_EQ(countOf("certificates-"), 9);
}

TEST(Plan, FacesAtOnePlaceAndEyesHaveSections) {
    EXPECT_EQ(
        lineOf({.effort = Effort::smallest}, "coplanar"),
        "cdr coplanar --frames 1 --search-views 1 --size 64x36 --techniques anchored --threads 1 --seed "
        "2013 --out coplanar --json data/coplanar.json");
    EXPECT_EQ(lineOf({}, "stereo-none"),
              "cdr render alley --technique anchored --colours bright --shadows anchored --aov wrong --size "
              "640x360 --threads 1 --seed 2013 --json data/stereo-none.json");
    EXPECT_EQ(lineOf({}, "stereo-toed-in-picture"),
              "cdr render alley --technique anchored --colours bright --shadows anchored --aov color --size "
              "640x360 --stereo toed-in --eye-distance 0.3 --converge 9 --threads 1 --seed 2013 "
              "-o stereo-toed-in-picture.png --json data/stereo-toed-in-picture.json");
}

std::vector<std::string> namesOf(const std::vector<std::string>& sections) {
    std::vector<std::string> names;
    for (const Section& section : makePlan({.sections = sections})) {
        names.push_back(section.name);
    }
    return names;
}

TEST(Plan, HoldsWhatIsAskedForInThePagesOrder) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(namesOf({}).size(), planTable().size());
    EXPECT_EQ(namesOf({"probe", "flicker"}), (Names{"flicker", "flicker-near", "probe"}));
    EXPECT_EQ(namesOf({"certificates-afc", "flicker-near"}),
              (Names{"flicker-near", "certificates-afc-standard", "certificates-afc-reversed",
                     "certificates-afc-anchored"}));
    EXPECT_EQ(namesOf({"stereo"}), (Names{"stereo-none", "stereo-parallel", "stereo-toed-in",
                                          "stereo-parallel-picture", "stereo-toed-in-picture"}));
    for (const char* none : {"", "flick", "flicker-", "probe "}) {
        EXPECT_THROW(namesOf({"probe", none}), base::InputError) << none;
    }
}

} // namespace

} // namespace cdr::report_test
