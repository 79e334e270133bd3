#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/probe/probe.h>
#include <experiments/rivals/needs_command.h>
#include <experiments/rivals/row_columns.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/readable.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace cdr::cli {

namespace {

struct ProbeArguments {
    experiments::ProbeOptions options;
    std::filesystem::path state;
};

/// Measured over predicted, where both are known.
std::optional<double> ratioOf(const experiments::ProbeResult& result) {
    return result.resolvedView ? std::optional(*result.resolvedView / result.predictedView) : std::nullopt;
}

/// Behind what is only known to be no more, as the ladder ends there.
const char* orLess(const experiments::ProbeResult& result) {
    return result.resolvesAll ? " or less" : "";
}

output::Columns<experiments::ProbeResult> probeColumns(base::LengthUnit unit) {
    using Result = experiments::ProbeResult;
    const auto text = [unit](double view) {
        return base::quantityText(view, unit, base::NumberStyle::plain);
    };
    const auto resolvedText = [text](const Result& result) {
        return result.resolvedView     ? text(*result.resolvedView) + orLess(result)
               : result.pairsSeen == 0 ? "no pixel tells"
                                       : "none, > " + text(result.largestView);
    };
    const auto predictedText = [unit](const Result& result) {
        return result.isRival() ? std::string()
               : std::isfinite(result.predictedView)
                   ? fmt::format("{}", output::Readable{result.predictedView, unit})
                   : "none";
    };
    const auto ratioText = [](const Result& result) {
        const std::optional<double> ratio = ratioOf(result);
        return ratio && *ratio > 0.0 ? fmt::format("{}{}", output::Readable{*ratio}, orLess(result)) : "";
    };
    return {
        {.key = "technique", .value = &Result::technique, .heading = "technique"},
        experiments::rivalColumn(&Result::isRival),
        experiments::formatColumn(&Result::format),
        {.key = "distance", .value = &Result::distanceView, .heading = "distance", .format = {.unit = unit}},
        {.key = "resolved", .value = &Result::resolvedView, .heading = "resolved", .text = resolvedText},
        {.key = "resolves_all", .value = &Result::resolvesAll},
        {.key = "pairs_seen", .value = &Result::pairsSeen},
        {.key = "predicted", .value = &Result::predictedView, .heading = "predicted", .text = predictedText},
        {.key = "ratio", .value = ratioOf, .heading = "measured / predicted", .text = ratioText},
        {.key = "guaranteed", .value = &Result::guaranteedView},
        {.key = "smallest", .value = &Result::smallestView},
        {.key = "largest", .value = &Result::largestView},
        {.key = "cascades", .value = &Result::cascades, .heading = "cascades"}};
}

/// The formats that are left out because the device lacks them; none where formats were asked for.
std::vector<std::string_view> missingFormats(const gpu::Device& device,
                                             const experiments::ProbeOptions& options) {
    const std::vector<depth::DepthFormat>& has = device.info().depthFormats;
    std::vector<std::string_view> missing;
    for (const depth::DepthFormat format : depth::kDepthFormats) {
        if (options.formats.empty() && std::find(has.begin(), has.end(), format) == has.end()) {
            missing.push_back(nameOf(format));
        }
    }
    return missing;
}

void run(Command& command, ProbeArguments& arguments) {
    experiments::ProbeOptions& options = arguments.options;
    const std::vector<std::string_view> missing = missingFormats(command.device(), options);
    command.keepUnits(arguments.state);
    const auto results =
        experiments::runProbe(command.device(), options, command.progress(), command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }
    const auto columns = probeColumns(command.unit());
    command.console().table(output::tableOf(columns, results));
    if (!missing.empty()) {
        command.console().line(
            fmt::format("left out, because the device cannot draw to it: {}", fmt::join(missing, ", ")));
    }
    printNeeds(command.console(), options.rivalsBeside);
    command.console().line(fmt::format("\n{}; seed {}; one picture of {}x{} per row", command.opened().text(),
                                       options.seed, options.drawing.width, options.drawing.height));

    auto document = command.makeDocument({{"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"seed", options.seed},
                                          {"snap_bits", options.drawing.snapBits}});
    document["results"] = output::jsonOf(columns, results);
    document["missing_formats"] = missing;
    addNeeds(document, options.rivalsBeside);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, ProbeArguments& arguments) {
    experiments::ProbeOptions& options = arguments.options;
    addDistances(command, options.distancesView);
    addTechniques(command, options.techniques);
    addRivalList(command, options.rivalsBeside, "none");
    options::addParsedList(command, "--formats", options.formats, depth::parseDepthFormat, kFormatsHelp)
        ->default_str("all");
    addSize(command, options.drawing.width, options.drawing.height);
    addThreads(command, options.drawing.threads);
    addSeed(command, options.seed);
    addSnapBits(command, options.drawing.snapBits);
    addState(command, arguments.state);
}

} // namespace

void addProbe(CLI::App& program, const GlobalOptions& global) {
    addCommand<ProbeArguments>(program, global, "probe",
                               "Measure and predict the smallest separation that each technique resolves",
                               addOptions, run, RankUse::all);
}

} // namespace cdr::cli
