#include "command.h"

#include "rank_machine.h"

#include <cdr/base/error.h>
#include <experiments/same_files.h>
#include <scenes/open_scene.h>
#include <scenes/orbit/data.h>

#include <fmt/format.h>

namespace cdr::cli {

void requireAlone(const ranks::Ranks& ranks, const std::string& name) {
    if (!ranks.isAlone()) {
        throw base::InputError(
            fmt::format("{} runs in one process, and not as {} ranks: start it without mpirun", name,
                        ranks.place().count));
    }
}

bool takesPart(const GlobalOptions& global, const std::string& name, RankUse use) {
    if (use == RankUse::none) {
        requireAlone(*global.ranks, name);
    }
    const ranks::Place& place = global.ranks->place();
    if (use == RankUse::timed && place.countOnNode > 1 && !global.shareMachine) {
        throw base::InputError(fmt::format(
            "{} measures time, and {} ranks share this machine: start one on each, or add --share-machine",
            name, place.countOnNode));
    }
    return use == RankUse::all || use == RankUse::timed || global.ranks->isFirst();
}

Command::Command(std::string name, const GlobalOptions& global, OutputOptions output)
    : m_name(std::move(name)),
      m_global(global),
      m_output(std::move(output)),
      m_console(global, m_output) {
    divideProcessors(ranks().place(), m_global.bind);
    m_device = global.device == "each" ? dealtDevice(ranks().place()) : global.device;
    if (global.section.empty()) { // a report has looked already
        requireKnownDevice(m_device);
    }
    if (m_output.json && *m_output.json != "-") {
        m_files.writes("--json", *m_output.json);
    }
}

void Command::sayRanks() const {
    if (!ranks().isAlone()) {
        m_console.line(textOf(ranks().place(), m_global.bind));
    }
}

void Command::reads(const std::filesystem::path& path) {
    m_files.reads(path);
    m_read.push_back(path);
    experiments::requireSameFiles(ranks(), path);
}

void Command::sayKept(const std::filesystem::path& state) const {
    ranks().sayWhenKilled(fmt::format("; what was finished stays in {}", state.string()));
}

nlohmann::ordered_json Command::digestsOfRead() const {
    nlohmann::ordered_json digests = nlohmann::ordered_json::object();
    for (const std::filesystem::path& path : m_read) {
        digests[path.string()] = experiments::digestOfFiles(path);
    }
    if (!m_earth.empty()) {
        digests["orbit"] = experiments::digestOfEarth(m_earth);
    }
    return digests;
}

scene::SceneSetup Command::openScene(const std::string& nameOrPath, std::uint64_t seed,
                                     const scene::GltfChoice& choice) {
    if (scene::isGltfPath(nameOrPath)) {
        reads(nameOrPath);
    } else if (nameOrPath == "orbit") {
        const scenes::OrbitFiles files = scenes::orbitFiles();
        m_earth = files.folder;
        experiments::requireSameEarth(ranks(), m_earth);
        if (!files.model.empty()) {
            reads(files.model);
        }
    }
    scene::GltfChoice bounded = choice;
    bounded.textureMiB = m_global.textureMiB;
    scene::OpenedScene opened = scenes::openScene(nameOrPath, seed, bounded);
    note(opened.notes);
    return std::move(opened.setup);
}

void Command::note(const std::vector<std::string>& ignored) {
    if (!m_notes) {
        m_notes.emplace();
    }
    for (const std::string& line : ignored) {
        m_console.warning("ignored: " + line);
        m_notes->push_back(line);
    }
}

const OpenedDevice& Command::opened() {
    if (!m_opened) {
        m_opened.emplace(m_device, m_global.validate);
    }
    return *m_opened;
}

std::function<void(std::size_t, std::size_t, const std::string&)> Command::progress() const {
    return [this](std::size_t done, std::size_t all, const std::string& what) {
        m_console.progress(done, all, what);
    };
}

std::function<void(std::size_t, std::size_t)> Command::progressOf(const std::string& what) const {
    return [this, what](std::size_t done, std::size_t all) { m_console.progress(done, all, what); };
}

void Command::endProgress() const {
    m_console.endProgress();
    if (m_opened) {
        m_opened->requireSilentValidation();
    }
}

nlohmann::ordered_json Command::makeDocument(nlohmann::ordered_json options) const {
    nlohmann::ordered_json document = host::makeDocument(
        m_name, m_opened ? m_opened->documentDevice() : host::DocumentDevice{}, std::move(options));
    if (m_global.hostCpus != 0) {
        document["host"]["cpus"] = m_global.hostCpus;
    }
    return document;
}

void Command::writeDocument(nlohmann::ordered_json document) const {
    if (m_output.json && ranks().isFirst()) {
        if (m_notes) {
            document["notes"] = *m_notes;
        }
        host::writeDocument(*m_output.json, document);
    }
}

} // namespace cdr::cli
