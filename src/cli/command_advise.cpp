#include "commands.h"
#include "console.h"

#include <cdr/base/error.h>
#include <cdr/depth/advice.h>
#include <cdr/scene/camera.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace cdr::cli {

namespace {

struct AdviseArguments {
    scene::Camera camera{.fovY = 0.0, .nearView = 0.1, .farView = 1e5};
    double fovDegrees = 60.0;
    std::uint32_t height = 720;
    std::optional<double> atView; ///< far when not given
    double spanView = 32.0;
    double separationView = 0.0;
    std::vector<std::string> formats;
    OutputOptions output;
};

depth::AdviceQuestion questionOf(const AdviseArguments& arguments) {
    scene::Camera camera = arguments.camera;
    camera.fovY = arguments.fovDegrees * std::numbers::pi / 180.0;
    scene::requireUsable(camera);
    depth::AdviceQuestion question{
        .scene = {.nearView = camera.nearView,
                  .farView = camera.farView,
                  .footprintSlope = 2.0 * std::tan(0.5 * camera.fovY) / arguments.height,
                  .atView = arguments.atView.value_or(camera.farView),
                  .spanView = arguments.spanView},
        .separationView = arguments.separationView};
    if (!arguments.formats.empty()) {
        question.formats.clear();
        for (const std::string& name : arguments.formats) {
            question.formats.push_back(depth::parseDepthFormat(name));
        }
    }
    return question;
}

nlohmann::ordered_json finiteOrNull(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json toJson(const depth::AdviceRow& row) {
    return {{"technique", row.technique.name},
            {"mapping", nameOf(row.technique.mapping)},
            {"split", nameOf(row.technique.split)},
            {"format", nameOf(row.technique.format)},
            {"cascades", row.forecast.cascades},
            {"buffer_step", finiteOrNull(row.forecast.bufferStepView)},
            {"vertex_step", finiteOrNull(row.forecast.rounding.distanceGapView)},
            {"predicted", finiteOrNull(row.forecast.resolvedView())},
            {"guaranteed", finiteOrNull(row.forecast.guaranteedView())},
            {"suffices", row.suffices}};
}

std::string stepText(double stepView) {
    return std::isfinite(stepView) ? fmt::format("{:.3g}", stepView) : "none";
}

void printTable(const Console& console, const depth::Advice& advice) {
    std::vector<std::vector<std::string>> rows;
    for (const depth::AdviceRow& row : advice.rows) {
        rows.push_back({row.technique.name, std::string(nameOf(row.technique.format)),
                        std::to_string(row.forecast.cascades), stepText(row.forecast.bufferStepView),
                        stepText(row.forecast.rounding.distanceGapView),
                        stepText(row.forecast.resolvedView()), row.suffices ? "yes" : "no"});
    }
    console.table({"technique", "format", "cascades", "depth step", "vertex rounding", "resolves", "enough"},
                  rows);
}

void run(const GlobalOptions& global, const AdviseArguments& arguments) {
    const depth::AdviceQuestion question = questionOf(arguments);
    const depth::Advice advice = depth::advise(question);
    const std::vector<std::string> lines = depth::explain(question, advice);
    const Console console(global, arguments.output);
    printTable(console, advice);
    console.line("");
    for (const std::string& line : lines) {
        console.line(line);
    }
    auto document = base::makeDocument("advise", {},
                                       {{"near", question.scene.nearView},
                                        {"far", question.scene.farView},
                                        {"fov_degrees", arguments.fovDegrees},
                                        {"height", arguments.height},
                                        {"at", question.scene.atView},
                                        {"span", question.scene.spanView},
                                        {"separation", question.separationView}});
    for (const depth::AdviceRow& row : advice.rows) {
        document["results"].push_back(toJson(row));
    }
    document["simplest"] =
        advice.simplest ? toJson(advice.rows[*advice.simplest]) : nlohmann::ordered_json(nullptr);
    document["widest_span"] = advice.widestSpanView;
    document["advice"] = lines;
    writeJson(arguments.output, document);
}

} // namespace

void addAdvise(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "advise",
        "Which technique resolves a separation at a distance, by formula, and the simplest that does");
    auto arguments = std::make_shared<AdviseArguments>();
    command->add_option("--near", arguments->camera.nearView, "Near plane, view distance")
        ->capture_default_str();
    command->add_option("--far", arguments->camera.farView, "Far plane, view distance")
        ->capture_default_str();
    command->add_option("--fov", arguments->fovDegrees, "Vertical field of view in degrees")
        ->capture_default_str();
    command->add_option("--height", arguments->height, "Height of the picture in pixels")
        ->check(CLI::Range(1u, 1u << 20))
        ->capture_default_str();
    command->add_option("--separation", arguments->separationView, "Smallest gap to tell apart, scene units")
        ->required();
    command->add_option("--at", arguments->atView, "View distance to tell it apart at; far when not given");
    command->add_option("--span", arguments->spanView, "Depth of what is visible around that distance")
        ->capture_default_str();
    command
        ->add_option("--format", arguments->formats, "Depth formats to consider, a comma between them; all")
        ->delimiter(',');
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
