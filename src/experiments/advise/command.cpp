#include <cdr/base/error.h>
#include <cdr/depth/advice.h>
#include <cdr/scene/frustum.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/advise/measured_advice.h>

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
    bool measured = false;
    experiments::MeasuredAdviceOptions measuring;
    OutputOptions output;
};

depth::AdviceQuestion questionOf(const AdviseArguments& arguments) {
    scene::Camera camera = arguments.camera;
    camera.fovY = arguments.fovDegrees * std::numbers::pi / 180.0;
    scene::requireUsable(camera);
    depth::AdviceQuestion question{
        .scene = {.nearView = camera.nearView,
                  .farView = camera.farView,
                  .footprintSlope = scene::frustumOf(camera, 1.0, arguments.height).footprintSlope,
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
    nlohmann::ordered_json json{{"technique", nameOf(row.technique)},
                                {"mapping", nameOf(row.technique.mapping)},
                                {"split", nameOf(row.technique.split)},
                                {"format", nameOf(row.technique.format)},
                                {"cascades", row.forecast.cascades},
                                {"buffer_step", finiteOrNull(row.forecast.bufferStepView)},
                                {"vertex_step", finiteOrNull(row.forecast.rounding.distanceGapView)},
                                {"predicted", finiteOrNull(row.forecast.resolvedView())},
                                {"guaranteed", finiteOrNull(row.forecast.guaranteedView())},
                                {"suffices", row.suffices},
                                {"cost", costOf(row)}};
    if (row.measured) {
        json["resolved"] = row.measured->resolvedView ? nlohmann::ordered_json(*row.measured->resolvedView)
                                                      : nlohmann::ordered_json(nullptr);
        json["largest"] = row.measured->largestView;
        json["time_ratio"] = row.measured->timeRatio;
        json["time_ratio_ci95"] = {row.measured->timeRatioLow, row.measured->timeRatioHigh};
    }
    return json;
}

std::string stepText(double stepView) {
    return std::isfinite(stepView) ? fmt::format("{:.3g}", stepView) : "none";
}

std::string measuredText(const depth::Measurement& measured) {
    return measured.resolvedView ? fmt::format("{:.3g}", *measured.resolvedView)
                                 : fmt::format("none, > {:.3g}", measured.largestView);
}

std::string timeText(const depth::Measurement& measured) {
    const auto percent = [](double ratio) { return 100.0 * (ratio - 1.0); };
    return fmt::format("{:+.1f} % ({:+.1f} to {:+.1f})", percent(measured.timeRatio),
                       percent(measured.timeRatioLow), percent(measured.timeRatioHigh));
}

void printTable(const Console& console, const depth::Advice& advice, bool measured) {
    std::vector<std::vector<std::string>> rows;
    for (const depth::AdviceRow& row : advice.rows) {
        rows.push_back({nameOf(row.technique), std::string(nameOf(row.technique.format)),
                        std::to_string(row.forecast.cascades), stepText(row.forecast.bufferStepView),
                        stepText(row.forecast.rounding.distanceGapView),
                        stepText(row.forecast.resolvedView())});
        if (measured) {
            rows.back().push_back(row.measured ? measuredText(*row.measured) : "");
            rows.back().push_back(row.measured ? timeText(*row.measured) : "");
        } else {
            rows.back().push_back(costOf(row));
        }
        rows.back().emplace_back(row.suffices ? "yes" : "no");
    }
    std::vector<std::string> header{"technique",  "format",          "cascades",
                                    "depth step", "vertex rounding", measured ? "predicted" : "resolves"};
    header.insert(header.end(), measured
                                    ? std::initializer_list<std::string>{"measured", "time over standard"}
                                    : std::initializer_list<std::string>{"cost over standard"});
    header.emplace_back("enough");
    console.table(header, rows);
}

/// The answer, and what it was measured on.
struct Answer {
    depth::AdviceQuestion question;
    depth::Advice advice;
    std::optional<host::DocumentDevice> device;
    std::string measuredOn;
};

Answer predict(const depth::AdviceQuestion& question) {
    return {.question = question, .advice = depth::advise(question), .device = {}, .measuredOn = {}};
}

Answer measure(const GlobalOptions& global, const AdviseArguments& arguments,
               const depth::AdviceQuestion& question, const Console& console) {
    depth::advise(question); // what is wrong with it comes before any device
    const Session session(global);
    Answer answer{.question = experiments::onDevice(session.device(), question),
                  .advice = {},
                  .device = session.documentDevice(),
                  .measuredOn = fmt::format(
                      "{}; separations: the ladder, one picture each; time: {} frames of "
                      "64,000 cubes each, interleaved, seed {}",
                      describe(session.device()), arguments.measuring.frames, arguments.measuring.seed)};
    answer.advice =
        experiments::measureAdvice(session.device(), answer.question, arguments.measuring,
                                   [&](std::size_t done, std::size_t all, const std::string& what) {
                                       console.progress(done, all, what);
                                   });
    console.endProgress();
    session.requireSilentValidation();
    return answer;
}

void run(const GlobalOptions& global, const AdviseArguments& arguments) {
    requireJsonWritable(arguments.output);
    const Console console(global, arguments.output);
    const depth::AdviceQuestion asked = questionOf(arguments);
    const auto [question, advice, device, measuredOn] =
        arguments.measured ? measure(global, arguments, asked, console) : predict(asked);
    const std::vector<std::string> lines = depth::explain(question, advice);
    printTable(console, advice, arguments.measured);
    console.line("");
    for (const std::string& line : lines) {
        console.line(line);
    }
    if (arguments.measured) {
        console.line("\n" + measuredOn);
    }
    auto document = host::makeDocument("advise", device.value_or(host::DocumentDevice{}),
                                       {{"near", question.scene.nearView},
                                        {"far", question.scene.farView},
                                        {"fov_degrees", arguments.fovDegrees},
                                        {"height", arguments.height},
                                        {"at", question.scene.atView},
                                        {"span", question.scene.spanView},
                                        {"separation", question.separationView},
                                        {"measured", arguments.measured}});
    if (arguments.measured) {
        document["options"]["frames"] = arguments.measuring.frames;
        document["options"]["seed"] = arguments.measuring.seed;
    }
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
        "Which technique resolves a separation at a distance, what it costs, and the simplest that suffices");
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
    command->add_flag("--measured", arguments->measured,
                      "Measure separations and frame times on the device, beside the formulas");
    command
        ->add_option("--frames", arguments->measuring.frames, "With --measured: frames timed per technique")
        ->check(CLI::Range(1u, 1u << 20))
        ->capture_default_str();
    command->add_option("--seed", arguments->measuring.seed, "With --measured: seed of both scenes")
        ->capture_default_str();
    command->add_option("--threads", arguments->measuring.threads, "With --measured: threads that record")
        ->capture_default_str();
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
