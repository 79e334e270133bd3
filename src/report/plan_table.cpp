#include "plan_table.h"

#include <string>

namespace cdr::report {

namespace {

/// A scene, and what a row of it takes.
struct TimedScene {
    std::string name;
    double quickSeconds = 0.0;
    double fullSeconds = 0.0;
};

/// Shadows of a scene. The page shows the pictures of the one that has a folder.
PlanRow shadowsOf(const TimedScene& scene, const std::string& folder = "") {
    return {.name = "shadows-" + scene.name,
            .command = "shadows",
            .options = {{"", {scene.name}},
                        {"--methods", {"plain,anchored"}},
                        {"--frames", {"2", "3", "8"}},
                        {"--size", {"160x90", "640x360", "1280x720"}},
                        {"--shadow-texels", {"512", "", ""}},
                        {"--threads", {kThreads}},
                        {"--seed", {kSeed}}},
            .folderOption = folder.empty() ? "" : "--out",
            .folder = folder,
            .isTimed = true,
            .quickSeconds = scene.quickSeconds,
            .fullSeconds = scene.fullSeconds};
}

/// A certificate of a scene. The output `wrong` casts every pixel after repair, which a certificate does not.
PlanRow certificateOf(const TimedScene& scene, const std::string& technique) {
    const std::string name = scene.name + "-" + technique;
    return {.name = "certificates-" + name,
            .command = "render",
            .options = {{"", {scene.name}},
                        {"--technique", {technique}},
                        {"--aov", {"wrong"}},
                        {"--frames", {"2", "5", "9"}},
                        {"--size", {"160x90", "640x360", "1280x720"}},
                        {"--threads", {kThreads}},
                        {"--seed", {kSeed}}},
            .folderOption = "--certify",
            .folder = "data/certificate-" + name + ".json",
            .isTimed = true,
            .quickSeconds = scene.quickSeconds,
            .fullSeconds = scene.fullSeconds};
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
                .folderOption = isPicture ? "-o" : "",
                .folder = isPicture ? name + ".png" : "",
                .quickSeconds = 1.0,
                .fullSeconds = 4.0};
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
        {.name = "precision", .command = "precision", .quickSeconds = 0.3, .fullSeconds = 0.3},
        {.name = "advise",
         .command = "advise",
         .options = {{"--near", {"0.001"}},
                     {"--far", {"2000000"}},
                     {"--fov", {"0.002"}},
                     {"--at", {"1000000"}},
                     {"--separation", {"0.01"}}},
         .quickSeconds = 0.1,
         .fullSeconds = 0.1},
        {.name = "pictures",
         .command = "pictures",
         .options = {{"--frames", {"1", "2", "12"}}, {"--size", hd}, threads, seed},
         .folderOption = "--out",
         .folder = "pictures",
         .quickSeconds = 4.0,
         .fullSeconds = 20.0},
        {.name = "flicker",
         .command = "flicker",
         .options = {{"--frames", {"4", "180", "360"}},
                     {"--size", flickerSize},
                     {"--flip-every", flipEvery},
                     {"--moved"},
                     {"--fitted-range"},
                     threads,
                     seed},
         .folderOption = kVideos,
         .folder = "videos",
         .quickSeconds = 28.0,
         .fullSeconds = 1500.0},
        {.name = "flicker-near",
         .command = "flicker",
         .options = {{"--near-object"},
                     {"--fitted-range"},
                     {"--frames", {"2", "30", "360"}},
                     {"--size", flickerSize},
                     {"--flip-every", flipEvery},
                     threads,
                     seed},
         .quickSeconds = 3.0,
         .fullSeconds = 500.0},
        {.name = "probe",
         .command = "probe",
         .options = {{"--distances",
                      {"100,1000000", "1,100,10000,1000000,100000000",
                       "1,10,100,1000,10000,100000,1000000,10000000,100000000"}},
                     {"--size", {"320x180", "1280x720", "1280x720"}},
                     threads,
                     seed},
         .quickSeconds = 4.0,
         .fullSeconds = 8.0},
        {.name = "timing",
         .command = "timing",
         .options = {{"--frames", {"2", "60", "10000"}},
                     {"--size", {"64x36", "640x360", "1280x720"}},
                     {"--modes", {"cdr-2,cdr-5,log,logcdr-5,reversed,anchored", "", ""}},
                     threads,
                     seed},
         .isTimed = true,
         .quickSeconds = 29.0,
         .fullSeconds = 8000.0},
        {.name = "scaling",
         .command = "scaling",
         .options = {{"--draws", {"300,600", "1000,20000", "1000,10000,100000,1000000"}},
                     {"--cascades", {"1", "1,4", "1,2,4,8"}},
                     {"--repeats", {"2", "5", "7"}},
                     seed,
                     {"--threads", {"1,2", "", ""}}},
         .isTimed = true,
         .quickSeconds = 28.0,
         .fullSeconds = 4000.0},
        {.name = "rivals",
         .command = "rivals",
         .options = {{"", {"mixed", "", ""}},
                     {"--frames", {"1", "6", "48"}},
                     {"--size", {"64x36", "1280x720", "1280x720"}},
                     {"--distances",
                      {"1000", "1000,1000000", "1,10,100,1000,10000,100000,1000000,10000000,100000000"}},
                     threads,
                     seed},
         .isTimed = true,
         .quickSeconds = 30.0,
         .fullSeconds = 300.0},
        {.name = "detail",
         .command = "detail",
         .options = {{"", {"cubes", "boulders", "boulders"}},
                     {"--frames", {"2", "6", "120"}},
                     {"--size", hd},
                     threads,
                     seed},
         .folderOption = "--out",
         .folder = "detail",
         .isTimed = true,
         .quickSeconds = 14.0,
         .fullSeconds = 300.0},
        {.name = "translucency",
         .command = "translucency",
         .options = {{"--size", {"96x54", "640x360", "1280x720"}},
                     {"--cascades", {"1,4", "1,2,4,8", "1,2,3,4,5,6,7,8"}},
                     threads,
                     seed},
         .folderOption = "--out",
         .folder = "translucency",
         .isTimed = true,
         .quickSeconds = 18.0,
         .fullSeconds = 60.0},
        shadowsOf({"alley", 2.0, 15.0}),
        shadowsOf({"afc", 2.5, 15.0}),
        shadowsOf({"mixed", 0.7, 5.0}),
        shadowsOf({"orbit", 16.0, 100.0}, "shadows"),
        {.name = "effects",
         .command = "effects",
         .options = {{"--frames", lensFrames}, {"--size", hd}, threads, seed},
         .folderOption = "--out",
         .folder = "effects",
         .isTimed = true,
         .quickSeconds = 16.0,
         .fullSeconds = 100.0},
        {.name = "focus",
         .command = "focus",
         .options =
             {{"--frames", lensFrames}, {"--size", hd}, {"--cameras", {"4", "64", "256"}}, threads, seed},
         .folderOption = "--out",
         .folder = "focus",
         .isTimed = true,
         .quickSeconds = 10.0,
         .fullSeconds = 60.0},
        {.name = "orbit",
         .command = "orbit",
         .options = {{"--frames", {"2", "7", "49"}}, {"--size", hd}, threads},
         .folderOption = "--out",
         .folder = "orbit",
         .quickSeconds = 7.0,
         .fullSeconds = 90.0},
        {.name = "inspect",
         .command = "inspect",
         .options = {{"", {"orbit"}},
                     {"--frames", {"2", "4", "24"}},
                     {"--size", {"160x90", "640x360", "1280x720"}},
                     threads},
         .folderOption = "--heat-map",
         .folder = "inspect.png",
         .quickSeconds = 8.0,
         .fullSeconds = 120.0},
        {.name = "coplanar",
         .command = "coplanar",
         .options = {{"--frames", {"1", "20", "5000"}},
                     {"--search-views", {"1", "4", "50"}},
                     {"--size", {"64x36", "160x90", "160x90"}},
                     {"--techniques", {"anchored", "standard,reversed,anchored", ""}},
                     threads,
                     seed},
         .folderOption = "--out",
         .folder = "coplanar",
         .quickSeconds = 15.0,
         .fullSeconds = 1500.0},
        stereoOf("none", "wrong"),
        stereoOf("parallel", "wrong"),
        stereoOf("toed-in", "wrong"),
        stereoOf("parallel", "color"),
        stereoOf("toed-in", "color"),
        certificateOf({"afc", 0.2, 2.0}, "standard"),
        certificateOf({"afc", 0.2, 2.0}, "reversed"),
        certificateOf({"afc", 0.2, 2.0}, "anchored"),
        certificateOf({"mixed", 0.2, 2.0}, "standard"),
        certificateOf({"mixed", 0.2, 2.0}, "reversed"),
        certificateOf({"mixed", 0.2, 2.0}, "anchored"),
        certificateOf({"orbit", 5.0, 50.0}, "standard"),
        certificateOf({"orbit", 3.0, 20.0}, "reversed"),
        certificateOf({"orbit", 3.0, 20.0}, "anchored")};
    return kTable;
}

} // namespace cdr::report
