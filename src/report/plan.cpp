#include "plan.h"

#include <fmt/format.h>

#include <utility>

namespace cdr::report {

namespace {

/// What the efforts differ in.
struct Amounts {
    const char* pictureFrames;
    const char* pictureSize;
    const char* probeDistances;
    const char* probeSize;
    const char* flickerFrames;
    const char* flickerSize;
    const char* flipEvery;
    const char* nearFrames;
    const char* timingFrames;
    const char* timingSize;
    const char* timingModes; ///< a comma between them; all when empty
    const char* draws;
    const char* cascades;
    const char* threads; ///< to twice the CPUs when empty
    const char* repeats;
    const char* detailScene;
    const char* detailFrames;
    const char* detailSize;
    const char* translucencySize;
    const char* translucencyCascades;
    const char* orbitFrames;
    const char* orbitSize;
    const char* lensFrames;
    const char* lensSize;
    const char* focusCameras;
};

constexpr Amounts kSmallest{.pictureFrames = "1",
                            .pictureSize = "160x90",
                            .probeDistances = "100,1000000",
                            .probeSize = "320x180",
                            .flickerFrames = "4",
                            .flickerSize = "160x90",
                            .flipEvery = "2",
                            .nearFrames = "2",
                            .timingFrames = "2",
                            .timingSize = "64x36",
                            .timingModes = "cdr-2,cdr-5,log,logcdr-5,reversed,anchored",
                            .draws = "300,600",
                            .cascades = "1",
                            .threads = "1,2",
                            .repeats = "2",
                            .detailScene = "cubes",
                            .detailFrames = "2",
                            .detailSize = "160x90",
                            .translucencySize = "96x54",
                            .translucencyCascades = "1,4",
                            .orbitFrames = "2",
                            .orbitSize = "160x90",
                            .lensFrames = "2",
                            .lensSize = "160x90",
                            .focusCameras = "4"};
constexpr Amounts kQuick{.pictureFrames = "2",
                         .pictureSize = "1280x720",
                         .probeDistances = "1,100,10000,1000000,100000000",
                         .probeSize = "1280x720",
                         .flickerFrames = "180",
                         .flickerSize = "640x360",
                         .flipEvery = "10",
                         .nearFrames = "30",
                         .timingFrames = "60",
                         .timingSize = "640x360",
                         .timingModes = "",
                         .draws = "1000,20000",
                         .cascades = "1,4",
                         .threads = "",
                         .repeats = "5",
                         .detailScene = "boulders",
                         .detailFrames = "6",
                         .detailSize = "1280x720",
                         .translucencySize = "640x360",
                         .translucencyCascades = "1,2,4,8",
                         .orbitFrames = "7",
                         .orbitSize = "1280x720",
                         .lensFrames = "10",
                         .lensSize = "1280x720",
                         .focusCameras = "64"};
constexpr Amounts kFull{.pictureFrames = "12",
                        .pictureSize = "1280x720",
                        .probeDistances = "1,10,100,1000,10000,100000,1000000,10000000,100000000",
                        .probeSize = "1280x720",
                        .flickerFrames = "360",
                        .flickerSize = "1280x720",
                        .flipEvery = "1",
                        .nearFrames = "360",
                        .timingFrames = "10000",
                        .timingSize = "1280x720",
                        .timingModes = "",
                        .draws = "1000,10000,100000,1000000",
                        .cascades = "1,2,4,8",
                        .threads = "",
                        .repeats = "7",
                        .detailScene = "boulders",
                        .detailFrames = "120",
                        .detailSize = "1280x720",
                        .translucencySize = "1280x720",
                        .translucencyCascades = "1,2,3,4,5,6,7,8",
                        .orbitFrames = "49",
                        .orbitSize = "1280x720",
                        .lensFrames = "120",
                        .lensSize = "1280x720",
                        .focusCameras = "256"};

const Amounts& amountsOf(Effort effort) {
    switch (effort) {
    case Effort::smallest:
        return kSmallest;
    case Effort::quick:
        return kQuick;
    case Effort::full:
        break;
    }
    return kFull;
}

/// Safe to paste into a shell.
std::string quoted(const std::string& argument) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+%";
    if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) {
        return argument;
    }
    std::string text = "'";
    for (const char c : argument) {
        text += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return text + "'";
}

} // namespace

std::filesystem::path Section::jsonFile() const {
    return std::filesystem::path("data") / (name + ".json");
}

std::vector<std::string> Section::commandIn(const std::filesystem::path& root) const {
    std::vector<std::string> command = arguments;
    if (!folderOption.empty()) {
        command.insert(command.end(), {folderOption, (root / folder).string()});
    }
    command.insert(command.end(), {"--json", (root / jsonFile()).string()});
    return command;
}

std::vector<Section> makePlan(const PlanOptions& options) {
    const Amounts& amounts = amountsOf(options.effort);
    const auto seconds = [&](double quick, double full) {
        switch (options.effort) {
        case Effort::smallest:
            return quick / 50.0;
        case Effort::quick:
            return quick;
        case Effort::full:
            break;
        }
        return full;
    };
    const auto rendered = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--threads", fmt::format("{}", options.threads), "--seed",
                                           fmt::format("{}", options.seed)});
        return arguments;
    };
    std::vector<std::string> timing{"timing", "--frames", amounts.timingFrames, "--size", amounts.timingSize};
    if (*amounts.timingModes != '\0') {
        timing.emplace_back("--modes");
        timing.emplace_back(amounts.timingModes);
    }
    std::vector<std::string> scaling{"scaling",       "--draws",        amounts.draws,
                                     "--cascades",    amounts.cascades, "--repeats",
                                     amounts.repeats, "--seed",         fmt::format("{}", options.seed)};
    if (*amounts.threads != '\0') {
        scaling.emplace_back("--threads");
        scaling.emplace_back(amounts.threads);
    }
    Section flicker{.name = "flicker",
                    .arguments =
                        rendered({"flicker", "--frames", amounts.flickerFrames, "--size", amounts.flickerSize,
                                  "--flip-every", amounts.flipEvery, "--moved", "--fitted-range"}),
                    .expectedSeconds = seconds(28.0, 1500.0)};
    if (options.videos) {
        flicker.folderOption = "--videos";
        flicker.folder = "videos";
    }
    return {
        {.name = "precision", .arguments = {"precision"}, .expectedSeconds = 0.3},
        {.name = "advise",
         .arguments = {"advise", "--near", "0.001", "--far", "2000000", "--fov", "0.002", "--at", "1000000",
                       "--separation", "0.01"},
         .expectedSeconds = 0.1},
        {.name = "pictures",
         .arguments =
             rendered({"pictures", "--frames", amounts.pictureFrames, "--size", amounts.pictureSize}),
         .folderOption = "--out",
         .folder = "pictures",
         .expectedSeconds = seconds(4.0, 20.0)},
        flicker,
        {.name = "flicker-near",
         .arguments = rendered({"flicker", "--near-object", "--fitted-range", "--frames", amounts.nearFrames,
                                "--size", amounts.flickerSize, "--flip-every", amounts.flipEvery}),
         .expectedSeconds = seconds(3.0, 500.0)},
        {.name = "probe",
         .arguments = rendered({"probe", "--distances", amounts.probeDistances, "--size", amounts.probeSize}),
         .expectedSeconds = seconds(4.0, 8.0)},
        {.name = "timing",
         .arguments = rendered(std::move(timing)),
         .expectedSeconds = seconds(29.0, 8000.0)},
        {.name = "scaling", .arguments = std::move(scaling), .expectedSeconds = seconds(28.0, 4000.0)},
        {.name = "detail",
         .arguments = rendered(
             {"detail", amounts.detailScene, "--frames", amounts.detailFrames, "--size", amounts.detailSize}),
         .folderOption = "--out",
         .folder = "detail",
         .expectedSeconds = seconds(14.0, 300.0)},
        {.name = "translucency",
         .arguments = rendered({"translucency", "--size", amounts.translucencySize, "--cascades",
                                amounts.translucencyCascades}),
         .folderOption = "--out",
         .folder = "translucency",
         .expectedSeconds = seconds(18.0, 60.0)},
        {.name = "effects",
         .arguments = rendered({"effects", "--frames", amounts.lensFrames, "--size", amounts.lensSize}),
         .folderOption = "--out",
         .folder = "effects",
         .expectedSeconds = seconds(16.0, 100.0)},
        {.name = "focus",
         .arguments = rendered({"focus", "--frames", amounts.lensFrames, "--size", amounts.lensSize,
                                "--cameras", amounts.focusCameras}),
         .folderOption = "--out",
         .folder = "focus",
         .expectedSeconds = seconds(10.0, 60.0)},
        {.name = "orbit",
         .arguments = {"orbit", "--frames", amounts.orbitFrames, "--size", amounts.orbitSize, "--threads",
                       fmt::format("{}", options.threads)},
         .folderOption = "--out",
         .folder = "orbit",
         .expectedSeconds = seconds(7.0, 90.0)},
    };
}

std::string commandLine(const Section& section, std::string_view device) {
    std::string line = "cdr";
    if (!device.empty()) {
        line += " --device " + quoted(std::string(device));
    }
    for (const std::string& argument : section.commandIn("")) {
        line += " " + quoted(argument);
    }
    return line;
}

} // namespace cdr::report
