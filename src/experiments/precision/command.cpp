#include <cdr/platform/file.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/precision/precision.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>

namespace cdr::cli {

namespace {

struct PrecisionArguments {
    experiments::PrecisionOptions options;
    std::string curveFile;
};

output::Columns<experiments::PrecisionCell> precisionColumns(base::LengthUnit unit) {
    using Cell = experiments::PrecisionCell;
    const auto ofThesis = [](auto value) {
        return [value](const Cell& cell) { return cell.thesisView ? value(cell) : output::absent(); };
    };
    const output::CellFormat distance{.missing = "never", .unit = unit};
    return {
        {.key = "technique", .value = &Cell::technique, .heading = "technique"},
        {.key = "format", .value = &Cell::format, .heading = "format"},
        {.key = "separation", .value = &Cell::separation, .heading = "separation", .format = {.unit = unit}},
        {.key = "depth", .value = &Cell::reachedFirstView, .heading = "first reached at", .format = distance},
        {.key = "held_last", .value = &Cell::heldLastView, .heading = "held last at", .format = distance},
        {.key = "thesis",
         .value = ofThesis([](const Cell& cell) { return output::Json(*cell.thesisView); }),
         .heading = "thesis",
         .format = {.unit = unit}},
        {.key = "difference_pct",
         .value = ofThesis([](const Cell& cell) {
             return output::Json(100.0 * (cell.reachedFirstView / *cell.thesisView - 1.0));
         }),
         .heading = "difference",
         .format = {"{:+} %"}}};
}

void writeCurve(const std::string& file, const experiments::PrecisionResult& result) {
    std::string csv = fmt::format("distance,{}\n", fmt::join(result.curveNames, ","));
    for (const auto& point : result.curve) {
        csv += fmt::format("{},{}\n", point.distanceView, fmt::join(point.separations, ","));
    }
    platform::writeText(file, csv);
}

void run(Command& command, PrecisionArguments& arguments) {
    command.files().mayWrite("--curve", arguments.curveFile);
    const experiments::PrecisionResult result = experiments::runPrecision(arguments.options);
    const Console& console = command.console();
    const auto columns = precisionColumns(command.unit());
    console.line("Table 4.1 of the thesis, by its own formulas, 24 bits:");
    console.table(output::tableOf(columns, result.table));
    console.line("\nEvery technique and depth format, by the exact step of the buffer alone:");
    console.table(output::tableOf(columns, result.byFormat));

    auto document = command.makeDocument(
        {{"near", arguments.options.nearView}, {"far", arguments.options.farView}, {"bits", 24}});
    document["results"] = output::jsonOf(columns, result.table);
    document["by_format"] = output::jsonOf(columns, result.byFormat);
    document["curve"] = {{"techniques", result.curveNames}, {"points", nlohmann::ordered_json::array()}};
    for (const auto& point : result.curve) {
        std::vector<double> row{point.distanceView};
        row.insert(row.end(), point.separations.begin(), point.separations.end());
        document["curve"]["points"].push_back(row);
    }
    if (!arguments.curveFile.empty()) {
        writeCurve(arguments.curveFile, result);
    }
    command.writeDocument(document);
}

void addOptions(CLI::App& command, PrecisionArguments& arguments) {
    addValue(command, "--near", arguments.options.nearView, options::kNearHelp);
    addValue(command, "--far", arguments.options.farView, options::kFarHelp);
    options::addFile(command, "--curve", arguments.curveFile,
                     "Write the curves of the thesis' Figure 4.1 as CSV to FILE");
}

} // namespace

void addPrecision(CLI::App& program, const GlobalOptions& global) {
    addCommand<PrecisionArguments>(
        program, global, "precision",
        "Compute by formula how far each technique resolves a separation (thesis Table 4.1)", addOptions, run,
        RankUse::first);
}

} // namespace cdr::cli
