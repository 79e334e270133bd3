#include <cdr/depth/advice.h>
#include <cdr/scene/frustum.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/advise/measured_advice.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/readable.h>
#include <output/sentence_parts.h>

#include <functional>
#include <numbers>

namespace cdr::cli {

namespace {

using output::Json;

struct AdviseArguments {
    scene::Camera camera{.fovY = 0.0, .nearView = 0.1, .farView = 1e5};
    double fovDegrees = 60.0;
    std::uint32_t height = 720;
    std::optional<double> atView; ///< far when not given
    double spanView = 32.0;
    double separationView = 0.0;
    std::optional<unsigned> subPixelBits;
    double slope = 1.0;
    std::vector<depth::DepthFormat> formats;
    std::vector<depth::NamedTechnique> techniques;
    bool measured = false;
    experiments::MeasuredAdviceOptions measuring;
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
                  .spanView = arguments.spanView,
                  .subPixelBits = arguments.subPixelBits,
                  .slope = arguments.slope},
        .separationView = arguments.separationView};
    if (!arguments.formats.empty()) {
        question.formats = arguments.formats;
    }
    for (const depth::NamedTechnique& named : arguments.techniques) {
        question.techniques.push_back(named.technique);
    }
    return question;
}

depth::LengthText lengthTextIn(base::LengthUnit unit) {
    return [unit](double view) { return base::quantityText(view, unit, base::NumberStyle::plain); };
}

std::string measuredText(const depth::Measurement& measured, base::LengthUnit unit) {
    const depth::LengthText text = lengthTextIn(unit);
    const char* bound = measured.resolvesAll ? " or less" : "";
    return measured.resolvedView         ? text(*measured.resolvedView) + bound
           : measured.largestView == 0.0 ? "no pixel tells"
                                         : "none, > " + text(measured.largestView);
}

std::string timeText(const depth::Measurement& measured) {
    const auto percent = [](double ratio) { return output::Readable{100.0 * (ratio - 1.0)}; };
    const std::string text = fmt::format("{:+} %", percent(measured.timeRatio));
    const auto& interval = measured.timeRatio95;
    return interval ? fmt::format("{} ({:+} to {:+})", text, percent(interval->low), percent(interval->high))
                    : text;
}

output::Json intervalJson(const std::optional<depth::RatioInterval>& interval) {
    return interval ? output::Json{interval->low, interval->high} : output::Json(nullptr);
}

using Row = depth::AdviceRow;

output::Columns<depth::Measurement> measuredColumns(base::LengthUnit unit) {
    using Measured = depth::Measurement;
    return {
        {.key = "resolved",
         .value = &Measured::resolvedView,
         .heading = "measured",
         .text = [unit](const Measured& m) { return measuredText(m, unit); },
         .before = "enough"},
        {.key = "resolves_all", .value = &Measured::resolvesAll},
        {.key = "largest",
         .value =
             [](const Measured& m) {
                 return m.largestView > 0.0 ? output::Json(m.largestView) : output::Json(nullptr);
             }},
        {.key = "time_ratio",
         .value = &Measured::timeRatio,
         .heading = "time over standard",
         .text = timeText,
         .before = "enough"},
        {.key = "time_ratio_ci95", .value = [](const Measured& m) { return intervalJson(m.timeRatio95); }}};
}

/// @param measured whether the table shows measurements, else costs in words.
output::Columns<Row> adviceColumns(bool measured, base::LengthUnit unit) {
    const auto step = [](auto value) {
        return [value](const Row& row) { return std::invoke(value, row.forecast); };
    };
    using Forecast = depth::Forecast;
    const output::CellFormat stepFormat{.missing = "none", .unit = unit};
    const output::Columns<Row> predicted{
        {.key = "technique",
         .value = [](const Row& row) { return nameOf(row.technique); },
         .heading = "technique"},
        {.key = "mapping", .value = [](const Row& row) { return nameOf(row.technique.mapping); }},
        {.key = "split", .value = [](const Row& row) { return nameOf(row.technique.split); }},
        {.key = "format",
         .value = [](const Row& row) { return nameOf(row.technique.format); },
         .heading = "format"},
        {.key = "cascades",
         .value = [](const Row& row) { return row.forecast.cascades; },
         .heading = "cascades"},
        {.key = "buffer_step",
         .value = step(&Forecast::bufferStepView),
         .heading = "depth step",
         .format = stepFormat},
        {.key = "vertex_step",
         .value = step([](const Forecast& forecast) { return forecast.rounding.distanceGapView; }),
         .heading = "vertex rounding",
         .format = stepFormat},
        {.key = "snap_step",
         .value = step([](const Forecast& forecast) { return forecast.rounding.snapGapView; })},
        {.key = "predicted",
         .value = step(&Forecast::resolvedView),
         .heading = measured ? "predicted" : "resolves",
         .format = stepFormat},
        {.key = "guaranteed", .value = step(&Forecast::guaranteedView)},
        {.key = "suffices",
         .value = &Row::suffices,
         .heading = "enough",
         .text = [](const Row& row) { return row.suffices ? "yes" : "no"; }},
        {.key = "cost",
         .value = [](const Row& row) { return costOf(row); },
         .heading = measured ? "" : "cost over standard",
         .before = "enough"}};
    return measured ? output::joined<Row>(
                          {predicted, output::columnsOf<Row>(&Row::measured, measuredColumns(unit))})
                    : predicted;
}

/// The answer, and what it was measured on.
struct Answer {
    depth::AdviceQuestion question;
    depth::Advice advice;
    std::string measuredOn;
};

/// Of the depth buffers that frames are timed with, for the rows of all formats.
depth::DepthFormat timeFormat(const depth::AdviceQuestion& question) {
    return question.formats.front();
}

Answer predict(const depth::AdviceQuestion& question) {
    return {.question = question, .advice = depth::advise(question), .measuredOn = {}};
}

Answer measure(Command& command, const AdviseArguments& arguments, const depth::AdviceQuestion& question) {
    depth::advise(question); // what is wrong with it comes before any device
    const gpu::Device& device = command.device();
    Answer answer{.question = experiments::onDevice(device, question), .advice = {}, .measuredOn = {}};
    answer.measuredOn = fmt::format("{}; separations: the ladder, one picture each; time: {} frames of "
                                    "64,000 cubes each in {}, interleaved, seed {}",
                                    command.opened().text(), arguments.measuring.frames,
                                    nameOf(timeFormat(answer.question)), arguments.measuring.seed);
    answer.advice =
        experiments::measureAdvice(device, answer.question, arguments.measuring, command.progress());
    command.endProgress();
    return answer;
}

void run(Command& command, AdviseArguments& arguments) {
    const Console& console = command.console();
    const depth::AdviceQuestion asked = questionOf(arguments);
    const auto [question, advice, measuredOn] =
        arguments.measured ? measure(command, arguments, asked) : predict(asked);
    const auto lines = depth::explain(question, advice, lengthTextIn(command.unit()));
    const auto columns = adviceColumns(arguments.measured, command.unit());
    console.table(output::tableOf(columns, advice.rows));
    console.line("");
    for (const std::string& line : lines) {
        console.line(line);
    }
    if (arguments.measured) {
        console.line("\n" + measuredOn);
    }
    auto document = command.makeDocument({{"near", question.scene.nearView},
                                          {"far", question.scene.farView},
                                          {"fov_degrees", arguments.fovDegrees},
                                          {"height", arguments.height},
                                          {"at", question.scene.atView},
                                          {"span", question.scene.spanView},
                                          {"separation", question.separationView},
                                          {"sub_pixel_bits", nullptr},
                                          {"slope", question.scene.slope},
                                          {"measured", arguments.measured}});
    if (question.scene.subPixelBits) {
        document["options"]["sub_pixel_bits"] = *question.scene.subPixelBits;
    }
    if (arguments.measured) {
        document["options"]["measured_width"] = arguments.measuring.width;
        document["options"]["measured_height"] = arguments.measuring.height;
        document["options"]["frames"] = arguments.measuring.frames;
        document["options"]["seed"] = arguments.measuring.seed;
        document["time_format"] = nameOf(timeFormat(question));
    }
    document["results"] = output::jsonOf(columns, advice.rows);
    document["simplest"] = advice.simplest ? output::jsonOf(columns, advice.rows[*advice.simplest])
                                           : nlohmann::ordered_json(nullptr);
    document["widest_span"] = advice.widestSpanView;
    document["advice"] = depth::explain(question, advice);
    document["advice_parts"] = output::sentenceParts(depth::explain(question, advice, output::markedLength));
    command.writeDocument(document);
}

void addOptions(CLI::App& command, AdviseArguments& arguments) {
    addValue(command, "--near", arguments.camera.nearView, options::kNearHelp);
    addValue(command, "--far", arguments.camera.farView, options::kFarHelp);
    addValue(command, "--fov", arguments.fovDegrees, options::kFovHelp);
    addValue(command, "--height", arguments.height, "Height of the picture in pixels, for the formulas")
        ->check(CLI::Range(1u, 1u << 20));
    command.add_option("--separation", arguments.separationView, "Gap that must be resolved, in scene units")
        ->required();
    command
        .add_option("--at", arguments.atView,
                    "Distance from the camera where it must be resolved, in scene units")
        ->default_str("that of --far");
    addValue(command, "--span", arguments.spanView,
             "Extent in depth of what is visible there, in scene units");
    command
        .add_option(
            "--sub-pixel-bits", arguments.subPixelBits,
            "Sub-pixel bits that the device rounds vertices to, 0 to 32; without it, both surfaces have the "
            "same outline, so that they are rounded alike")
        ->check(CLI::Range(0u, 32u));
    addValue(command, "--slope", arguments.slope,
             "Slope of the surfaces: the tangent of their angle to the picture");
    options::addParsedList(command, "--format", arguments.formats, depth::parseDepthFormat, kFormatsHelp)
        ->default_str("all");
    addTechniques(command, arguments.techniques);
    command.get_option("--techniques")->default_str("all presets, and two finer kinds of anchored");
    CLI::Option* measured = command.add_flag("--measured", arguments.measured,
                                             "Also measure separations and frame times on the device");
    addSize(command, arguments.measuring.width, arguments.measuring.height);
    addFrames(command, arguments.measuring.frames, "Measured frames of each technique", 1u << 20);
    addSeed(command, arguments.measuring.seed);
    addThreads(command, arguments.measuring.threads);
    for (const char* measuring : {"--size", "--frames", "--seed", "--threads"}) {
        command.get_option(measuring)->needs(measured);
    }
}

} // namespace

void addAdvise(CLI::App& program, const GlobalOptions& global) {
    addCommand<AdviseArguments>(
        program, global, "advise",
        "Say which techniques resolve a gap at a distance, what they cost, and which is the simplest",
        addOptions, run);
}

} // namespace cdr::cli
