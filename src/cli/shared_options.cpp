#include "shared_options.h"

#include <cdr/base/format_error.h>
#include <cdr/image/picture_size.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>

namespace cdr::cli {

namespace {

image::PictureSize parseSize(const std::string& text) {
    const auto size = image::parsePictureSize(text);
    if (!size) {
        throw base::inputError("size must be WIDTHxHEIGHT in pixels, such as 1280x720, not '{}'",
                               text.substr(0, 60));
    }
    return *size;
}

/// A scene behind a bare --json is one to open, and would be replaced. base::InputError for it.
void requireNoScene(const std::string& file) {
    const auto generated = scenes::generatedScenes();
    if (scene::isGltfPath(file) || std::find(generated.begin(), generated.end(), file) != generated.end()) {
        throw base::inputError(
            "--json takes a file to write, not the scene {}: write --json=FILE, or --json last",
            file.substr(0, 200));
    }
}

/// The names in a list that was divided at commas, some of which are part of a name: "standard/at:1,2", "anchored/fitted:1,max=2".
std::vector<std::string> techniqueNames(const std::vector<std::string>& parts) {
    std::vector<std::string> names;
    for (const std::string& part : parts) {
        // No technique's name begins with a digit or has "=" before a colon.
        const bool isNumber = part.find_first_of("0123456789.") == 0;
        if (!names.empty() && (isNumber || part.find('=') < part.find(':'))) {
            names.back() += "," + part;
        } else {
            names.push_back(part);
        }
    }
    return names;
}

} // namespace

void addJson(CLI::App& command, OutputOptions& output) {
    command
        .add_option_function<std::string>(
            "--json",
            [&output](const std::string& file) {
                requireNoScene(file);
                output.json = file.empty() ? "-" : file;
            },
            "Write the results as JSON to FILE; without FILE, to standard output")
        ->expected(0, 1)
        ->type_name("FILE");
}

void addDistances(CLI::App& command, std::vector<double>& distancesView) {
    addList(command, "--distances", distancesView,
            "Distances from the camera where separations are measured, separated by commas, in scene units");
}

void addCsv(CLI::App& command, std::filesystem::path& file) {
    options::addFile(command, "--csv", file, "Write the results as CSV to FILE");
}

void addPlot(CLI::App& command, std::filesystem::path& file, const std::string& what) {
    options::addFile(command, "--plot", file,
                     fmt::format("Plot {} to FILE, .png or .svg (needs gnuplot)", what));
}

void addTrace(CLI::App& command, std::filesystem::path& file, const std::string& what) {
    options::addFile(
        command, "--trace", file,
        fmt::format("Write a timeline of {} to FILE, for ui.perfetto.dev or chrome://tracing", what));
}

void addState(CLI::App& command, std::filesystem::path& state) {
    options::addFile(command, "--state", state, kStateHelp);
}

std::string textOf(const CLI::App& command) {
    constexpr std::array<std::string_view, 3> kLeftOut{"help", "json", "state"};
    std::string text;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_single_name();
        if (std::find(kLeftOut.begin(), kLeftOut.end(), name) == kLeftOut.end()) {
            text += fmt::format("{}={}\n", name,
                                option->count() > 0 ? fmt::format("{}", fmt::join(option->results(), " "))
                                                    : option->get_default_str());
        }
    }
    return text;
}

nlohmann::ordered_json givenOptions(const CLI::App& command) {
    constexpr std::array<std::string_view, 14> kNotWhat{"help",  "json",    "videos",   "tga",  "curve",
                                                        "state", "output",  "out",      "csv",  "plot",
                                                        "trace", "certify", "heat-map", "ranks"};
    auto given = nlohmann::ordered_json::object();
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_single_name();
        const bool isLeftOut = std::find(kNotWhat.begin(), kNotWhat.end(), name) != kNotWhat.end();
        if (option->count() > 0 && !isLeftOut) {
            given[name] = option->results();
        }
    }
    return given;
}

void addSize(CLI::App& command, std::uint32_t& width, std::uint32_t& height) {
    command
        .add_option_function<std::string>(
            "--size",
            [&width, &height](const std::string& text) {
                const image::PictureSize size = parseSize(text);
                width = size.width;
                height = size.height;
            },
            "Size of the picture in pixels")
        ->type_name("WIDTHxHEIGHT")
        ->default_str(fmt::format("{}x{}", width, height));
}

void addFrames(CLI::App& command, std::uint32_t& frames, const std::string& help, std::uint32_t most) {
    addValue(command, "--frames", frames, help)->check(CLI::Range(1u, most));
}

CLI::Option* addTechniques(CLI::App& command, std::vector<depth::NamedTechnique>& techniques) {
    return command
        .add_option_function<std::vector<std::string>>(
            "--techniques",
            [&techniques](const std::vector<std::string>& parts) {
                const std::vector<std::string> names = techniqueNames(parts);
                options::requireDistinct(names);
                techniques.clear();
                for (const std::string& name : names) {
                    techniques.push_back(depth::namedTechnique(name));
                }
            },
            "Techniques to compare, separated by commas: " + options::techniqueHelp())
        ->expected(CLI::detail::expected_max_vector_size)
        ->delimiter(',')
        ->default_str("all presets");
}

void addRivalList(CLI::App& command, std::vector<rivals::NamedRival>& chosen, const std::string& otherwise) {
    std::vector<std::string_view> known;
    for (const rivals::NamedRival& named : rivals::namedRivals()) {
        known.push_back(named.name);
    }
    options::addParsedList(
        command, "--rivals", chosen, rivals::parseRival,
        fmt::format("Rivals to compare, separated by commas: {}, each also as NAME/prepass",
                    fmt::join(known, ", ")))
        ->default_str(otherwise);
}

} // namespace cdr::cli
