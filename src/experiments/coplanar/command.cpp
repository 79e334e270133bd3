#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/coplanar/coplanar.h>

#include <fmt/format.h>
#include <options/number_checks.h>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <program/build_info.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cdr::cli {

namespace {

struct CoplanarArguments {
    experiments::CoplanarOptions options;
    std::filesystem::path folder;
    std::filesystem::path state;
};

output::Columns<experiments::CoplanarResult> coplanarColumns() {
    using Result = experiments::CoplanarResult;
    const auto ofOffset = [](float render::LayerOptions::*factor) {
        return [factor](const Result& result) {
            return result.method == experiments::CoplanarMethod::polygonOffset
                       ? output::Json(result.layers.*factor)
                       : output::Json(nullptr);
        };
    };
    return {{.key = "technique", .value = &Result::technique, .heading = "technique"},
            {.key = "method",
             .value = [](const Result& result) { return nameOf(result.method); },
             .heading = "method"},
            {.key = "slope_factor",
             .value = ofOffset(&render::LayerOptions::slopeFactor),
             .heading = "slope factor"},
            {.key = "constant_factor",
             .value = ofOffset(&render::LayerOptions::constantFactor),
             .heading = "constant factor"},
            {.key = "pixels", .value = &Result::pixels},
            {.key = "wrong", .value = &Result::wrong, .heading = "wrong"},
            {.key = "wrong_share",
             .value = &Result::wrongShare,
             .heading = "of all",
             .format = {.pattern = "{} %", .scale = 100.0}},
            {.key = "coverage", .value = &Result::coverage},
            {.key = "wrong_views", .value = &Result::wrongViews, .heading = "views with any"},
            {.key = "through", .value = &Result::through, .heading = "through a wall"},
            {.key = "flips", .value = &Result::flips, .heading = "flips"},
            {.key = "coverage_flips", .value = &Result::coverageFlips, .heading = "by rounded vertices"}};
}

std::string coplanarPicture(const std::string& technique, experiments::CoplanarMethod method) {
    std::string name = fmt::format("{}_{}.png", technique, nameOf(method));
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

/// The files that may be written.
std::vector<std::string> coplanarFiles(const std::vector<depth::NamedTechnique>& techniques) {
    std::vector<std::string> files;
    for (const depth::NamedTechnique& technique : techniques) {
        for (const experiments::CoplanarMethod method : experiments::kCoplanarMethods) {
            files.push_back(coplanarPicture(technique.name, method));
        }
    }
    return files;
}

void run(Command& command, CoplanarArguments& arguments) {
    experiments::CoplanarOptions& options = arguments.options;
    const PictureFolder folder(arguments.folder, command.files(),
                               PictureFolder::oneOf(coplanarFiles(options.techniques)));
    command.keepUnits(arguments.state);
    const auto results = experiments::runCoplanar(command.device(), options,
                                                  command.progressOf("pairs of views"), command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }

    const auto columns = coplanarColumns();
    command.console().table(output::tableOf(columns, results));
    command.console().line(fmt::format(
        "\n{}; {} pairs of views of the scene coplanar, {}x{}; polygon offset is the best of {} settings over {} "
        "other views; commit {}",
        command.opened().text(), options.views, options.drawing.width, options.drawing.height,
        options.offsets.slopes.size() * options.offsets.constants.size(), options.searchViews,
        program::buildInfo().commit));
    auto document = command.makeDocument({{"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"views", options.views},
                                          {"search_views", options.searchViews},
                                          {"slopes", options.offsets.slopes},
                                          {"constants", options.offsets.constants},
                                          {"threads", options.drawing.threads},
                                          {"seed", options.seed},
                                          {"snap_bits", options.drawing.snapBits}});
    for (const experiments::CoplanarResult& result : results) {
        auto& row = document["results"].emplace_back(output::jsonOf(columns, result));
        if (!result.picture.pixels.empty()) {
            folder.write("picture", coplanarPicture(result.technique, result.method), result.picture, row);
        }
    }
    command.writeDocument(document);
}

/// A list of factors of polygon offset.
void addFactors(CLI::App& command, const char* name, std::vector<float>& factors, const char* help) {
    constexpr double kMost = 1e6;
    addList(command, name, factors, help)->check(options::numberFrom(-kMost, kMost));
}

void addOptions(CLI::App& command, CoplanarArguments& arguments) {
    experiments::CoplanarOptions& options = arguments.options;
    addFrames(command, options.views,
              "Random views; each is repeated from 0.01 scene units aside, to count flips");
    addValue(command, "--search-views", options.searchViews,
             "Views over which the settings of polygon offset are compared")
        ->check(CLI::Range(1u, 10'000u));
    addFactors(command, "--slopes", options.offsets.slopes,
               "Slope factors of polygon offset, separated by commas");
    addFactors(command, "--constants", options.offsets.constants,
               "Constant factors of polygon offset for each slope factor, separated by commas");
    addSize(command, options.drawing.width, options.drawing.height);
    addThreads(command, options.drawing.threads);
    addSeed(command, options.seed);
    addState(command, arguments.state);
    addSnapBits(command, options.drawing.snapBits);
    addTechniques(command, options.techniques);
    options::addFolder(command, "--out", arguments.folder,
                       "Folder for a heat map of each method's worst view");
}

} // namespace

void addCoplanar(CLI::App& program, const GlobalOptions& global) {
    addCommand<CoplanarArguments>(
        program, global, "coplanar",
        "Count pixels that show the wrong one of two faces at the same place, without and with polygon offset or "
        "layers",
        addOptions, run, RankUse::all);
}

} // namespace cdr::cli
