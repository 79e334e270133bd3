#pragma once

#include "command_files.h"
#include "console.h"
#include "opened_device.h"
#include "shared_options.h"

#include <CLI/CLI.hpp>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <cdr/scene/scene_setup.h>
#include <scenes/orbit/data.h>

#include <nlohmann/json.hpp>
#include <runs/kept_ranks.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli {

/// A command that runs: where it prints, the files it reads and writes, the device it opens, its JSON.
class Command {
  public:
    /// base::InputError when --device names none, or --json a file that cannot be written.
    /// @param app of the command's options.
    Command(const CLI::App& app, const GlobalOptions& global, OutputOptions output);

    const GlobalOptions& global() const { return m_global; }
    /// Of lengths in tables and sentences.
    base::LengthUnit unit() const { return m_global.unit.value_or(base::LengthUnit::none); }
    /// Of models: what the global options choose of them.
    scene::GltfChoice modelChoice(scene::GltfChoice choice = {}) const {
        choice.textureMiB = m_global.textureMiB;
        choice.pointRadius = m_global.pointRadius;
        return choice;
    }
    const OutputOptions& output() const { return m_output; }
    const Console& console() const { return m_console; }
    CommandFiles& files() { return m_files; }
    ranks::Ranks& ranks() { return m_kept ? static_cast<ranks::Ranks&>(*m_kept) : *m_global.ranks; }
    const ranks::Ranks& ranks() const { return *m_global.ranks; }
    /// Where several ranks work on the command, says how many and how they share the machine.
    void sayRanks() const;

    /// Notes a file that the command reads, which all ranks have to find alike. base::InputError where they do not, where the
    /// command writes it, and where it is glTF and cannot be read.
    void reads(const std::filesystem::path& path);

    /// The same of the Earth's pictures, which may be missing, and of the model if there is one.
    void readsEarth(const scenes::OrbitFiles& files);

    /// Where a file is named, ranks() keep there what they make from now on, and take from there what an earlier run made. For
    /// every rank, once all files are read. base::InputError as runs::KeptRanks.
    /// @param more that results depend on, beside version, device, options, and the files that the command has read so far.
    void keepUnits(const std::filesystem::path& state, const std::string& more = "");
    /// The same, without a line that says how many results are there.
    void openState(const std::filesystem::path& state, const std::string& more = "");
    /// The ranks() that keep units; null where no file is named.
    runs::KeptRanks* keptRanks() { return m_kept ? &*m_kept : nullptr; }

    /// Opens a scene as scenes::openScene(), or of a glTF file what is chosen. Notes what of the file is not
    /// drawn. base::InputError when something is chosen of a scene that is no file.
    scene::SceneSetup openScene(const std::string& nameOrPath, std::uint64_t seed,
                                const scene::GltfChoice& choice = {});

    /// Says what of a file is not drawn: in a line each, on standard error where the command is quiet. JSON has the lines as
    /// "notes" and their files as "noted_files". A command that opens a scene calls it, if only with no lines.
    /// @param source the file.
    void note(const std::string& source, const std::vector<std::string>& ignored);

    /// The device that the global options name; the first call opens it.
    const OpenedDevice& opened();
    const gpu::Device& device() { return opened().device(); }

    /// Shows how far a part of the work is, which begins now; for an experiment to call before each step.
    std::function<void(std::size_t done, std::size_t all, const std::string& what)> progress() const;
    std::function<void(std::size_t done, std::size_t all)> progressOf(const std::string& what) const;
    /// After the last step. base::RunError when the validation layers had anything to say.
    void endProgress() const;

    /// From now on JSON counts the processors that this rank may use, and not those that one process would have.
    void measuresTime() { m_measuresTime = true; }

    /// What the command's JSON begins with, up to empty results and the options that were given. The device has empty texts
    /// where the command opened none.
    nlohmann::ordered_json makeDocument(nlohmann::ordered_json options) const;
    /// Writes the document where --json asks for it.
    void writeDocument(nlohmann::ordered_json document) const;

  private:
    /// @param what has these files, for messages.
    void readsAll(const std::string& what, const std::vector<scene::GltfReference>& files);
    /// A SHA-256 of everything that results depend on.
    std::string digestOfRun(const std::string& more);

    const CLI::App& m_app;
    std::string m_name;
    const GlobalOptions& m_global;
    OutputOptions m_output;
    Console m_console;
    CommandFiles m_files;
    std::vector<scene::GltfReference> m_read;
    std::optional<std::vector<std::string>> m_notes; ///< none where no scene was opened
    std::vector<std::string> m_notedFiles;           ///< of each note
    std::string m_device;                            ///< of this rank, as gpu::Device takes it
    std::optional<OpenedDevice> m_opened;
    std::optional<runs::KeptRanks> m_kept;
    bool m_measuresTime = false;
};

/// Which ranks of a run a command runs on.
enum class RankUse : std::uint8_t {
    none,  ///< in one process alone
    first, ///< takes next to no time, so the first rank does it while the others wait
    timed, ///< each takes its units, which are timed: on machines of their own, except with --share-machine
    all    ///< each takes its units
};

/// base::InputError, naming what, where it was started as several ranks.
void requireAlone(const ranks::Ranks& ranks, const std::string& name);

/// Whether a command runs on this rank. base::InputError where it may not run on several.
bool takesPart(const GlobalOptions& global, const std::string& name, RankUse use);

/// Adds a command to the program, with --json; it runs when it is chosen.
/// @param addOptions the options that fill the arguments.
template <typename Arguments>
void addCommand(CLI::App& program, const GlobalOptions& global, const std::string& name,
                const std::string& help, void (*addOptions)(CLI::App&, Arguments&),
                void (*run)(Command&, Arguments&), RankUse use = RankUse::none) {
    CLI::App* app = program.add_subcommand(name, help);
    auto arguments = std::make_shared<std::pair<Arguments, OutputOptions>>();
    addOptions(*app, arguments->first);
    addJson(*app, arguments->second);
    app->callback([&global, app, name, arguments, run, use] {
        if (takesPart(global, name, use)) {
            Command command(*app, global, arguments->second);
            if (use == RankUse::all || use == RankUse::timed) {
                command.sayRanks();
            }
            if (use == RankUse::timed) {
                command.measuresTime();
            }
            run(command, arguments->first);
        }
    });
}

} // namespace cdr::cli
