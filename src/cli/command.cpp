#include "command.h"

#include <cdr/base/error.h>
#include <scenes/open_scene.h>

namespace cdr::cli {

namespace {

scene::OpenedScene openChosen(const std::string& nameOrPath, std::uint64_t seed,
                              const scene::GltfChoice& choice) {
    if (!choice.scene && !choice.camera) {
        return scenes::openScene(nameOrPath, seed);
    }
    if (!scene::isGltfPath(nameOrPath)) {
        throw base::InputError("--gltf-scene and --camera are for .gltf and .glb files, not " + nameOrPath);
    }
    return scene::openGltf(nameOrPath, choice);
}

} // namespace

Command::Command(std::string name, const GlobalOptions& global, OutputOptions output)
    : m_name(std::move(name)),
      m_global(global),
      m_output(std::move(output)),
      m_console(global, m_output) {
    if (m_output.json && *m_output.json != "-") {
        m_files.writes("--json", *m_output.json);
    }
}

scene::SceneSetup Command::openScene(const std::string& nameOrPath, std::uint64_t seed,
                                     const scene::GltfChoice& choice) {
    if (scene::isGltfPath(nameOrPath)) {
        m_files.reads(nameOrPath);
    }
    scene::OpenedScene opened = openChosen(nameOrPath, seed, choice);
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
        m_opened.emplace(m_global.device, m_global.validate);
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
    return host::makeDocument(m_name, m_opened ? m_opened->documentDevice() : host::DocumentDevice{},
                              std::move(options));
}

void Command::writeDocument(nlohmann::ordered_json document) const {
    if (m_output.json) {
        if (m_notes) {
            document["notes"] = *m_notes;
        }
        host::writeDocument(*m_output.json, document);
    }
}

} // namespace cdr::cli
