#include <cdr/base/error.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/columns.h>
#include <experiments/probe/probe.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cdr::cli {

namespace {

struct ProbeArguments {
    experiments::ProbeOptions options;
    std::vector<std::string> techniques;
    std::vector<std::string> formats;
    std::string size = "1280x720";
    OutputOptions output;
};

/// Measured over predicted, where both are known.
std::optional<double> ratioOf(const experiments::ProbeResult& result) {
    return result.resolvedView ? std::optional(*result.resolvedView / result.predictedView) : std::nullopt;
}

experiments::Columns<experiments::ProbeResult> probeColumns() {
    using Result = experiments::ProbeResult;
    const auto resolvedText = [](const Result& result) {
        return result.resolvedView ? fmt::format("{:.3g}", *result.resolvedView)
                                   : fmt::format("none, > {:.3g}", result.largestView);
    };
    const auto ratioText = [](const Result& result) {
        const std::optional<double> ratio = ratioOf(result);
        return ratio && *ratio > 0.0 ? fmt::format("{:.2f}", *ratio) : "";
    };
    return {{.key = "technique", .value = &Result::technique, .heading = "technique"},
            {.key = "format", .value = &Result::format, .heading = "format"},
            {.key = "distance", .value = &Result::distanceView, .heading = "distance"},
            {.key = "resolved",
             .value = [](const Result& result) { return experiments::finiteOrNull(result.resolvedView); },
             .heading = "resolved",
             .text = resolvedText},
            {.key = "predicted",
             .value = [](const Result& result) { return experiments::finiteOrNull(result.predictedView); },
             .heading = "predicted",
             .format = {.pattern = "{:.3g}", .missing = "none"}},
            {.key = "ratio",
             .value = [](const Result& result) { return experiments::finiteOrNull(ratioOf(result)); },
             .heading = "measured / predicted",
             .text = ratioText},
            {.key = "guaranteed",
             .value = [](const Result& result) { return experiments::finiteOrNull(result.guaranteedView); }},
            {.key = "smallest", .value = &Result::smallestView},
            {.key = "largest", .value = &Result::largestView},
            {.key = "cascades", .value = &Result::cascades, .heading = "cascades"}};
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
    const auto columns = probeColumns();
    console.table(experiments::tableOf(columns, results));
    console.line(fmt::format("\n{}; seed {}; one picture each of {}x{}", describe(session.device()),
                             arguments.options.seed, size.width, size.height));

    auto document = base::makeDocument(
        "probe", session.documentDevice(),
        {{"width", size.width}, {"height", size.height}, {"seed", arguments.options.seed}});
    document["results"] = experiments::jsonOf(columns, results);
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
