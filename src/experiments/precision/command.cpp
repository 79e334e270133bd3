#include <cdr/host/file.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/precision/precision.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cdr::cli {

namespace {

struct PrecisionArguments {
    experiments::PrecisionOptions options;
    std::string curveFile;
    OutputOptions output;
};

/// JSON has no infinity; null stands for "never".
nlohmann::ordered_json finiteOrNull(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json toJson(const experiments::PrecisionCell& cell) {
    nlohmann::ordered_json json{{"technique", cell.technique},
                                {"format", cell.format},
                                {"separation", cell.separation},
                                {"depth", finiteOrNull(cell.reachedFirstView)},
                                {"held_last", finiteOrNull(cell.heldLastView)}};
    if (cell.thesisView) {
        json["thesis"] = *cell.thesisView;
        json["difference_pct"] = 100.0 * (cell.reachedFirstView / *cell.thesisView - 1.0);
    }
    return json;
}

std::string distanceText(double distanceView) {
    return std::isfinite(distanceView) ? fmt::format("{:.3f}", distanceView) : "never";
}

void printTable(const Console& console, const std::vector<experiments::PrecisionCell>& cells) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& cell : cells) {
        rows.push_back(
            {cell.technique, cell.format, fmt::format("{}", cell.separation),
             distanceText(cell.reachedFirstView), distanceText(cell.heldLastView),
             cell.thesisView ? fmt::format("{:.3f}", *cell.thesisView) : "",
             cell.thesisView
                 ? fmt::format("{:+.4f} %", 100.0 * (cell.reachedFirstView / *cell.thesisView - 1.0))
                 : ""});
    }
    console.table(
        {"technique", "format", "separation", "first reached at", "held last at", "thesis", "difference"},
        rows);
}

void writeCurve(const std::string& file, const experiments::PrecisionResult& result) {
    std::string csv = fmt::format("distance,{}\n", fmt::join(result.curveNames, ","));
    for (const auto& point : result.curve) {
        csv += fmt::format("{},{}\n", point.distanceView, fmt::join(point.separations, ","));
    }
    host::writeFile(file, {reinterpret_cast<const std::uint8_t*>(csv.data()), csv.size()});
}

void run(const GlobalOptions& global, const PrecisionArguments& arguments) {
    const experiments::PrecisionResult result = experiments::runPrecision(arguments.options);
    const Console console(global, arguments.output);
    console.line("Table 4.1 of the thesis, by its own formulas, 24 bits:");
    printTable(console, result.table);
    console.line("\nEvery technique and depth format, by the exact step of the buffer alone:");
    printTable(console, result.byFormat);

    auto document = host::makeDocument(
        "precision", {},
        {{"near", arguments.options.nearView}, {"far", arguments.options.farView}, {"bits", 24}});
    for (const auto& cell : result.table) {
        document["results"].push_back(toJson(cell));
    }
    auto& byFormat = host::addSection(document, "by_format");
    for (const auto& cell : result.byFormat) {
        byFormat.push_back(toJson(cell));
    }
    document["curve"] = {{"techniques", result.curveNames}, {"points", nlohmann::ordered_json::array()}};
    for (const auto& point : result.curve) {
        std::vector<double> row{point.distanceView};
        row.insert(row.end(), point.separations.begin(), point.separations.end());
        document["curve"]["points"].push_back(row);
    }
    if (!arguments.curveFile.empty()) {
        writeCurve(arguments.curveFile, result);
    }
    writeJson(arguments.output, document);
}

} // namespace

void addPrecision(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "precision", "Smallest resolvable separation over distance, by formula (Table 4.1)");
    auto arguments = std::make_shared<PrecisionArguments>();
    command->add_option("--near", arguments->options.nearView, "Near plane, view distance")
        ->capture_default_str();
    command->add_option("--far", arguments->options.farView, "Far plane, view distance")
        ->capture_default_str();
    command->add_option("--curve", arguments->curveFile, "Write the curves of Figure 4.1 as CSV");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
