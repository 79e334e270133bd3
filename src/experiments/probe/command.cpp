#include <cdr/base/error.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/probe/probe.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cdr::cli {

namespace {

struct ProbeArguments {
    experiments::ProbeOptions options;
    std::vector<std::string> techniques;
    std::vector<std::string> formats;
    std::string size = "1280x720";
    OutputOptions output;
};

/// JSON has no infinity; null stands for it, and for what was not resolved.
nlohmann::ordered_json numberOrNull(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// Measured over predicted, where both are known.
std::optional<double> ratioOf(const experiments::ProbeResult& result) {
    return result.resolvedView ? std::optional(*result.resolvedView / result.predictedView) : std::nullopt;
}

nlohmann::ordered_json toJson(const experiments::ProbeResult& result) {
    return {{"technique", result.technique},
            {"format", result.format},
            {"distance", result.distanceView},
            {"resolved", numberOrNull(result.resolvedView)},
            {"predicted", numberOrNull(result.predictedView)},
            {"ratio", numberOrNull(ratioOf(result))},
            {"guaranteed", numberOrNull(result.guaranteedView)},
            {"smallest", result.smallestView},
            {"largest", result.largestView},
            {"cascades", result.cascades}};
}

void printTable(const Console& console, const std::vector<experiments::ProbeResult>& results) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : results) {
        const std::optional<double> ratio = ratioOf(result);
        rows.push_back(
            {result.technique, result.format, fmt::format("{}", result.distanceView),
             result.resolvedView ? fmt::format("{:.3g}", *result.resolvedView)
                                 : fmt::format("none, > {:.3g}", result.largestView),
             std::isfinite(result.predictedView) ? fmt::format("{:.3g}", result.predictedView) : "none",
             ratio && *ratio > 0.0 ? fmt::format("{:.2f}", *ratio) : "", std::to_string(result.cascades)});
    }
    console.table(
        {"technique", "format", "distance", "resolved", "predicted", "measured / predicted", "cascades"},
        rows);
}

void run(const GlobalOptions& global, ProbeArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    arguments.options.width = size.width;
    arguments.options.height = size.height;
    for (const std::string& name : arguments.techniques) {
        arguments.options.techniques.push_back(depth::namedTechnique(name));
    }
    if (!arguments.formats.empty()) {
        arguments.options.formats.clear();
        for (const std::string& name : arguments.formats) {
            arguments.options.formats.push_back(depth::parseDepthFormat(name));
        }
    }
    requireJsonWritable(arguments.output);
    const Session session(global);
    const Console console(global, arguments.output);
    const auto results = experiments::runProbe(
        session.device(), arguments.options, [&](std::size_t done, std::size_t all, const std::string& what) {
            console.progress(done, all, what);
        });
    console.endProgress();
    session.requireSilentValidation();
    printTable(console, results);
    console.line(fmt::format("\n{}; seed {}; one picture each of {}x{}", describe(session.device()),
                             arguments.options.seed, size.width, size.height));

    auto document = host::makeDocument(
        "probe", session.documentDevice(),
        {{"width", size.width}, {"height", size.height}, {"seed", arguments.options.seed}});
    for (const auto& result : results) {
        document["results"].push_back(toJson(result));
    }
    writeJson(arguments.output, document);
}

} // namespace

void addProbe(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "probe", "Smallest separation each technique resolves, measured and predicted");
    auto arguments = std::make_shared<ProbeArguments>();
    command
        ->add_option("--distances", arguments->options.distancesView, "View distances, a comma between them")
        ->delimiter(',')
        ->capture_default_str();
    command
        ->add_option("--techniques", arguments->techniques, "Techniques, a comma between them; all presets")
        ->delimiter(',');
    command->add_option("--formats", arguments->formats, "Depth formats, a comma between them; all")
        ->delimiter(',');
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--threads", arguments->options.threads, "Threads that cull, bin and record")
        ->capture_default_str();
    command->add_option("--seed", arguments->options.seed, "Seed of the ladder")->capture_default_str();
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
