#include "plan_table.h"

#include <string>

namespace cdr::report {

namespace {

/// Shadows of a scene. The page shows the pictures of the one that has a folder.
PlanRow shadowsOf(const std::string& scene, const PlanSeconds& seconds, const PlanOut& out = {}) {
    return {.name = "shadows-" + scene,
            .command = "shadows",
            .options = {{"", {scene}},
                        {"--methods", {"plain,anchored"}},
                        {"--frames", {"2", "3", "8"}},
                        {"--size", {"160x90", "640x360", "1280x720"}},
                        {"--shadow-texels", {"512", "", ""}},
                        {"--threads", {kThreads}},
                        {"--seed", {kSeed}}},
            .out = out,
            .isTimed = true,
            .seconds = seconds};
}

/// A certificate of a scene. The output `wrong` casts every pixel after repair, which a certificate does not.
PlanRow certificateOf(const std::string& scene, const std::string& technique, const PlanSeconds& seconds) {
    const std::string name = scene + "-" + technique;
    return {.name = "certificates-" + name,
            .command = "render",
            .options = {{"", {scene}},
                        {"--technique", {technique}},
                        {"--aov", {"wrong"}},
                        {"--frames", {"2", "5", "9"}},
                        {"--size", {"240x135", "640x360", "1280x720"}},
                        {"--threads", {kThreads}},
                        {"--seed", {kSeed}}},
            .out = {"--certify", "data/certificate-" + name + ".json"},
            .isTimed = true,
            .seconds = seconds};
}

/// Two eyes, or one, in `alley`. An output that is a picture goes to a file; `wrong` is counted alone.
PlanRow stereoOf(const std::string& stereo, const std::string& aov) {
    const bool isPicture = aov == "color";
    const std::string name = "stereo-" + stereo + (isPicture ? "-picture" : "");
    PlanRow row{.name = name,
                .command = "render",
                .options = {{"", {"alley"}},
                            {"--technique", {"anchored"}},
                            {"--colours", {"bright"}},
                            {"--shadows", {"anchored"}},
                            {"--aov", {aov}},
                            {"--size", {"160x90", "640x360", "1280x720"}}},
                .out = isPicture ? PlanOut{"-o", name + ".png"} : PlanOut{},
                .seconds = {1.0, 4.0}};
    if (stereo != "none") {
        row.options.insert(row.options.end(),
                           {{"--stereo", {stereo}}, {"--eye-distance", {"0.3"}}, {"--converge", {"9"}}});
    }
    row.options.insert(row.options.end(), {{"--threads", {kThreads}}, {"--seed", {kSeed}}});
    return row;
}

} // namespace

const std::vector<PlanRow>& planTable() {
    const std::vector<std::string> hd{"160x90", "1280x720", "1280x720"};
    const std::vector<std::string> flickerSize{"160x90", "640x360", "1280x720"};
    const std::vector<std::string> flipEvery{"2", "10", "1"};
    const std::vector<std::string> lensFrames{"2", "10", "120"};
    const PlanOption threads{"--threads", {kThreads}};
    const PlanOption seed{"--seed", {kSeed}};
    static const std::vector<PlanRow> kTable{
        {.name = "precision", .seconds = {0.3, 0.3}},
        {.name = "advise",
         .options = {{"--near", {"0.001"}},
                     {"--far", {"2000000"}},
                     {"--fov", {"0.002"}},
                     {"--at", {"1000000"}},
                     {"--separation", {"0.01"}}},
         .seconds = {0.1, 0.1}},
        {.name = "pictures",
         .options = {{"--frames", {"1", "2", "12"}}, {"--size", hd}, threads, seed},
         .out = {"--out", "pictures"},
         .seconds = {4.0, 20.0}},
        {.name = "flicker",
         .options = {{"--frames", {"4", "180", "360"}},
                     {"--size", flickerSize},
                     {"--flip-every", flipEvery},
                     {"--moved"},
                     {"--fitted-range"},
                     threads,
                     seed},
         .out = {kVideos, "videos"},
         .seconds = {28.0, 1500.0}},
        {.name = "flicker-near",
         .command = "flicker",
         .options = {{"--near-object"},
                     {"--fitted-range"},
                     {"--frames", {"2", "30", "360"}},
                     {"--size", flickerSize},
                     {"--flip-every", flipEvery},
                     threads,
                     seed},
         .seconds = {3.0, 500.0}},
        {.name = "probe",
         .options = {{"--distances",
                      {"100,1000000", "1,100,10000,1000000,100000000",
                       "1,10,100,1000,10000,100000,1000000,10000000,100000000"}},
                     {"--size", {"320x180", "1280x720", "1280x720"}},
                     threads,
                     seed},
         .seconds = {4.0, 8.0}},
        {.name = "timing",
         .options = {{"--frames", {"2", "60", "10000"}},
                     {"--size", {"64x36", "640x360", "1280x720"}},
                     {"--modes", {"cdr-2,cdr-5,log,logcdr-5,reversed,anchored", "", ""}},
                     threads,
                     seed},
         .isTimed = true,
         .seconds = {29.0, 8000.0}},
        {.name = "scaling",
         .options = {{"--draws", {"300,600", "1000,20000", "1000,10000,100000,1000000"}},
                     {"--cascades", {"1", "1,4", "1,2,4,8"}},
                     {"--repeats", {"2", "5", "7"}},
                     seed,
                     {"--threads", {"1,2", "", ""}}},
         .isTimed = true,
         .seconds = {28.0, 4000.0}},
        {.name = "rivals",
         .options = {{"", {"mixed", "", ""}},
                     {"--frames", {"1", "6", "48"}},
                     {"--size", {"64x36", "1280x720", "1280x720"}},
                     {"--distances",
                      {"1000", "1000,1000000", "1,10,100,1000,10000,100000,1000000,10000000,100000000"}},
                     threads,
                     seed},
         .isTimed = true,
         .seconds = {30.0, 300.0}},
        {.name = "detail",
         .options = {{"", {"cubes", "boulders", "boulders"}},
                     {"--frames", {"2", "6", "120"}},
                     {"--size", hd},
                     threads,
                     seed},
         .out = {"--out", "detail"},
         .isTimed = true,
         .seconds = {14.0, 300.0}},
        {.name = "translucency",
         .options = {{"--size", {"96x54", "640x360", "1280x720"}},
                     {"--cascades", {"1,4", "1,2,4,8", "1,2,3,4,5,6,7,8"}},
                     threads,
                     seed},
         .out = {"--out", "translucency"},
         .isTimed = true,
         .seconds = {18.0, 60.0}},
        shadowsOf("alley", {2.0, 15.0}),
        shadowsOf("afc", {2.5, 15.0}),
        shadowsOf("mixed", {0.7, 5.0}),
        shadowsOf("orbit", {16.0, 100.0}, {"--out", "shadows"}),
        {.name = "effects",
         .options = {{"--frames", lensFrames}, {"--size", hd}, threads, seed},
         .out = {"--out", "effects"},
         .isTimed = true,
         .seconds = {16.0, 100.0}},
        {.name = "focus",
         .options =
             {{"--frames", lensFrames}, {"--size", hd}, {"--cameras", {"4", "64", "256"}}, threads, seed},
         .out = {"--out", "focus"},
         .isTimed = true,
         .seconds = {10.0, 60.0}},
        {.name = "orbit",
         .options = {{"--frames", {"2", "7", "49"}}, {"--size", hd}, threads},
         .out = {"--out", "orbit"},
         .seconds = {7.0, 90.0}},
        {.name = "inspect",
         .options = {{"", {"orbit"}},
                     {"--frames", {"2", "4", "24"}},
                     {"--size", {"160x90", "640x360", "1280x720"}},
                     threads},
         .out = {"--heat-map", "inspect.png"},
         .seconds = {8.0, 120.0}},
        {.name = "coplanar",
         .options = {{"--frames", {"1", "20", "5000"}},
                     {"--search-views", {"1", "4", "50"}},
                     {"--size", {"64x36", "160x90", "160x90"}},
                     {"--techniques", {"anchored", "standard,reversed,anchored", ""}},
                     threads,
                     seed},
         .out = {"--out", "coplanar"},
         .seconds = {15.0, 1500.0}},
        stereoOf("none", "wrong"),
        stereoOf("parallel", "wrong"),
        stereoOf("toed-in", "wrong"),
        stereoOf("parallel", "color"),
        stereoOf("toed-in", "color"),
        certificateOf("afc", "standard", {0.2, 2.0}),
        certificateOf("afc", "reversed", {0.2, 2.0}),
        certificateOf("afc", "anchored", {0.2, 2.0}),
        certificateOf("mixed", "standard", {0.2, 2.0}),
        certificateOf("mixed", "reversed", {0.2, 2.0}),
        certificateOf("mixed", "anchored", {0.2, 2.0}),
        certificateOf("orbit", "standard", {5.0, 50.0}),
        certificateOf("orbit", "reversed", {3.0, 20.0}),
        certificateOf("orbit", "anchored", {3.0, 20.0})};
    return kTable;
}

} // namespace cdr::report
