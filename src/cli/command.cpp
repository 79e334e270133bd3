#include "command.h"

#include "rank_machine.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/platform/thread_placement.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <output/document.h>
#include <program/build_info.h>
#include <program/sha256.h>
#include <runs/same_files.h>

#include <algorithm>
#include <thread>

namespace cdr::cli {

namespace {

ProcessorUse processorUse(const GlobalOptions& global) {
    return global.bind ? ProcessorUse::bound : ProcessorUse::free;
}

/// Shows how far a part of the work is, and how long the rest of it takes.
class PartProgress {
  public:
    explicit PartProgress(const Console& console) : m_console(&console) {}

    void operator()(std::size_t done, std::size_t all, const std::string& what) {
        // An earlier run may have done some, and the next part begins at 0.
        if (!m_first || done <= *m_first) {
            m_first = done;
            m_watch = {};
        }
        std::optional<double> secondsLeft;
        if (done > *m_first) {
            secondsLeft =
                m_watch.seconds() * static_cast<double>(all - done) / static_cast<double>(done - *m_first);
        }
        m_console->progress(done, all, what, secondsLeft);
    }

  private:
    const Console* m_console;
    platform::Stopwatch m_watch;
    std::optional<std::size_t> m_first;
};

} // namespace

void requireAlone(const ranks::Ranks& ranks, const std::string& name) {
    if (!ranks.isAlone()) {
        throw base::inputError("{} runs in one process, and not as {} ranks: start it without mpirun", name,
                               ranks.place().count);
    }
}

bool takesPart(const GlobalOptions& global, const std::string& name, RankUse use) {
    if (use == RankUse::none) {
        requireAlone(*global.ranks, name);
    }
    const ranks::Place& place = global.ranks->place();
    if (use == RankUse::timed && place.countOnNode > 1 && !global.shareMachine) {
        throw base::inputError(
            "{} measures time, and {} ranks share this machine: start one on each, or add --share-machine",
            name, place.countOnNode);
    }
    return use == RankUse::all || use == RankUse::timed || global.ranks->isFirst();
}

Command::Command(const CLI::App& app, const GlobalOptions& global, OutputOptions output)
    : m_app(app),
      m_name(app.get_name()),
      m_global(global),
      m_output(std::move(output)),
      m_console(global, m_output) {
    divideProcessors(ranks().place(), processorUse(m_global));
    m_device = deviceOf(global.device, ranks().place());
    if (global.section.empty()) { // a report has looked already
        requireKnownDevice(m_device);
    }
    if (const CLI::Option* folder = app.get_option_no_throw("--out")) {
        m_files.makes(folder->as<std::string>());
    }
    if (m_output.json && *m_output.json != "-") {
        m_files.writes("--json", *m_output.json);
    }
}

void Command::sayRanks() const {
    if (!ranks().isAlone()) {
        m_console.line(textOf(ranks().place(), processorUse(m_global)));
    }
}

void Command::reads(const std::filesystem::path& path) {
    std::vector<scene::GltfReference> files{{.uri = path.string(), .path = path}};
    if (scene::isGltfPath(path)) {
        const std::vector<scene::GltfReference> others = scene::gltfReferences(path);
        files.insert(files.end(), others.begin(), others.end());
    }
    readsAll(path.string(), files);
}

void Command::readsEarth(const scenes::OrbitFiles& files) {
    std::vector<scene::GltfReference> pictures;
    for (const std::filesystem::path& file : scenes::earthFiles(files.folder)) {
        pictures.push_back({.uri = file.filename().string(), .path = file});
    }
    readsAll("orbit", pictures);
    if (!files.model.empty()) {
        reads(files.model);
    }
}

void Command::readsAll(const std::string& what, const std::vector<scene::GltfReference>& files) {
    for (const scene::GltfReference& file : files) {
        m_files.reads(file.path);
    }
    m_read.insert(m_read.end(), files.begin(), files.end());
    runs::requireSameFiles(*m_global.ranks, what, files);
}

std::string Command::digestOfRun(const std::string& more) {
    const program::BuildInfo build = program::buildInfo();
    const gpu::DeviceInfo& device = this->device().info();
    const nlohmann::ordered_json parts{{"command", m_name},
                                       {"version", build.version},
                                       {"commit", build.commit},
                                       {"device", {device.name, device.driver, device.api}},
                                       {"options", textOf(m_app)},
                                       {"texture_memory", m_global.textureMiB.value_or(0)},
                                       {"points", m_global.pointRadius.value_or(0.0)},
                                       {"files", runs::digestOfFiles(m_read)},
                                       {"more", more}};
    return program::sha256Of(platform::textOf(parts, -1));
}

void Command::openState(const std::filesystem::path& state, const std::string& more) {
    if (state.empty()) {
        return;
    }
    m_files.writes("--state", state);
    m_global.ranks->sayWhenKilled(fmt::format("; what was finished stays in {}", state.string()));
    m_kept.emplace(*m_global.ranks, state, ranks().isFirst() ? digestOfRun(more) : "");
}

void Command::keepUnits(const std::filesystem::path& state, const std::string& more) {
    openState(state, more);
    if (m_kept && m_kept->keptCount() > 0) {
        m_console.line(fmt::format("results kept in {}: {}", state.string(), m_kept->keptCount()));
    }
}

scene::SceneSetup Command::openScene(const std::string& nameOrPath, std::uint64_t seed,
                                     const scene::GltfChoice& choice) {
    std::string source = nameOrPath;
    if (scene::isGltfPath(nameOrPath)) {
        reads(nameOrPath);
    } else if (scenes::readsEarth(nameOrPath)) {
        const scenes::OrbitFiles files = scenes::orbitFiles();
        readsEarth(files);
        if (!files.model.empty()) {
            source = files.model.string();
        }
    }
    const auto reading = progress();
    scene::OpenedScene opened =
        scenes::openScene(nameOrPath, seed, modelChoice(choice), [&](std::size_t done, std::size_t all) {
            reading(100 * done / std::max<std::size_t>(all, 1), 100, "% of " + nameOrPath);
        });
    m_console.endProgress();
    note(source, opened.notes);
    return std::move(opened.setup);
}

void Command::note(const std::string& source, const std::vector<std::string>& ignored) {
    if (!m_notes) {
        m_notes.emplace();
    }
    for (const std::string& line : ignored) {
        m_console.warning(fmt::format("{}: ignored: {}", platform::oneLine(source), line));
        m_notes->push_back(line);
        m_notedFiles.push_back(source);
    }
}

const OpenedDevice& Command::opened() {
    if (!m_opened) {
        m_opened.emplace(m_device, m_global.validate ? Validation::on : Validation::off);
    }
    return *m_opened;
}

std::function<void(std::size_t, std::size_t, const std::string&)> Command::progress() const {
    return PartProgress(m_console);
}

std::function<void(std::size_t, std::size_t)> Command::progressOf(const std::string& what) const {
    return [what, part = PartProgress(m_console)](std::size_t done, std::size_t all) mutable {
        part(done, all, what);
    };
}

void Command::endProgress() const {
    m_console.endProgress();
    if (m_opened) {
        m_opened->requireSilentValidation();
    }
}

nlohmann::ordered_json Command::makeDocument(nlohmann::ordered_json options) const {
    const program::BuildInfo build = program::buildInfo();
    const gpu::DeviceInfo device = m_opened ? m_opened->device().info() : gpu::DeviceInfo{};
    nlohmann::ordered_json document{
        {"command", m_name},
        {"version", build.version},
        {"commit", build.commit},
        {"device", {{"name", device.name}, {"driver", device.driver}, {"api", device.api}}},
        {"host", {{"cpus", std::thread::hardware_concurrency()}}},
        {"options", std::move(options)},
        {"results", nlohmann::ordered_json::array()},
        {"given", givenOptions(m_app)}};
    // Those of the program that change what is drawn.
    if (m_global.textureMiB) {
        document["given"]["texture-memory"] = std::vector{std::to_string(*m_global.textureMiB)};
    }
    if (m_global.pointRadius) {
        document["given"]["points"] = std::vector{fmt::format("{}", *m_global.pointRadius)};
    }
    if (m_global.hostCpus != 0) {
        document["host"]["cpus"] = m_measuresTime ? platform::allowedCpus().size() : m_global.hostCpus;
    }
    return document;
}

void Command::writeDocument(nlohmann::ordered_json document) const {
    if (m_output.json && ranks().isFirst()) {
        if (m_notes) {
            document["notes"] = *m_notes;
            document["noted_files"] = m_notedFiles;
        }
        output::writeDocument(*m_output.json, document);
    }
}

} // namespace cdr::cli
