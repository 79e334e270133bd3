#include "command_files.h"

#include "picture_folder.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <output/gnuplot.h>

#include <algorithm>
#include <optional>

namespace cdr::cli {

namespace {

namespace fs = std::filesystem;

/// With links followed as far as there are files.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path.lexically_normal() : whole;
}

/// The same of a folder, whose name may end in a slash.
fs::path resolvedFolder(const fs::path& folder) {
    const fs::path whole = resolved(folder);
    return whole.filename().empty() ? whole.parent_path() : whole;
}

/// The name with links followed, then the identity of the file if there is one. Paths that share one of these are of one file.
std::vector<std::string> keysOf(const fs::path& path) {
    std::vector<std::string> keys{resolved(path).string()};
    if (const std::optional<platform::FileIdentity> file = platform::identityOf(path)) {
        keys.push_back(fmt::format("//{}:{}", file->device, file->number)); // no name begins so
    }
    return keys;
}

[[noreturn]] void refuseRead(const fs::path& path, const std::string& option) {
    throw base::inputError("{}: {} would replace what the command reads", path.string(), option);
}

[[noreturn]] void refuseBoth(const fs::path& path, const std::string& first, const std::string& second) {
    throw base::inputError("{}: both {} and {} would write it", path.string(), first, second);
}

/// Whether there is something at the path that is no regular file, such as a device.
bool isSpecial(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

} // namespace

void CommandFiles::reads(const fs::path& path) {
    const std::vector<std::string> keys = keysOf(path);
    if (const Output* output = sameOutput(keys)) {
        refuseRead(output->path, output->option);
    }
    m_inputs.insert(keys.begin(), keys.end());
}

void CommandFiles::writes(const std::string& option, const fs::path& path) {
    if (isInMade(path)) {
        requireFolder(m_made);
    } else {
        platform::requireWritable(path);
    }
    if (isSpecial(path)) {
        return;
    }
    const Output output{option, path, keysOf(path)};
    requireApart(output);
    if (const Output* other = sameOutput(output.keys)) {
        refuseBoth(path, other->option, option);
    }
    for (const Sequence& sequence : m_sequences) {
        for (std::size_t number = sequence.begin; number < sequence.end; ++number) {
            if (isSameName(sequence.nameAt(number), output)) {
                refuseBoth(path, sequence.option, option);
            }
        }
    }
    note(output);
}

bool CommandFiles::isInMade(const fs::path& path) const {
    std::error_code error;
    return !m_made.empty() && !fs::exists(m_made, error) &&
           resolved(path).parent_path() == resolvedFolder(m_made);
}

void CommandFiles::mayWrite(const std::string& option, const fs::path& path) {
    if (!path.empty()) {
        writes(option, path);
    }
}

void CommandFiles::mayPlot(const fs::path& path) {
    if (!path.empty()) {
        writes("--plot", path);
        output::requirePlottable(path);
    }
}

void CommandFiles::writesSequence(const std::string& option, std::size_t begin, std::size_t end,
                                  const std::function<fs::path(std::size_t)>& nameAt) {
    const std::vector<Output> others = m_outputs;
    m_sequences.push_back({option, begin, end, nameAt});
    for (std::size_t number = begin; number < end; ++number) {
        const fs::path path = nameAt(number);
        for (const Output& other : others) {
            if (other.option != option && isSameName(path, other)) {
                refuseBoth(path, other.option, option);
            }
        }
        std::error_code error;
        if (fs::exists(path, error)) { // else nothing is lost
            notePresent(option, path);
        }
    }
}

void CommandFiles::writesFolder(const std::string& option, const fs::path& folder,
                                const std::function<bool(const std::string&)>& isWritten) {
    m_folders.push_back({option, resolvedFolder(folder), isWritten});
    for (const Output& output : m_outputs) {
        requireApart(output);
    }
    std::error_code error; // of a folder that is not there yet, which has nothing to lose
    for (fs::directory_iterator file(folder, error), end; file != end; file.increment(error)) {
        if (isWritten(file->path().filename().string())) {
            notePresent(option, file->path());
        }
    }
}

bool CommandFiles::isSameName(const fs::path& path, const Output& output) {
    if (path.filename() != output.path.filename()) {
        return false;
    }
    const std::vector<std::string> keys = keysOf(path);
    return std::find_first_of(keys.begin(), keys.end(), output.keys.begin(), output.keys.end()) != keys.end();
}

const CommandFiles::Output* CommandFiles::sameOutput(const std::vector<std::string>& keys) const {
    std::size_t first = m_outputs.size();
    for (const std::string& key : keys) {
        if (const auto found = m_outputOf.find(key); found != m_outputOf.end()) {
            first = std::min(first, found->second);
        }
    }
    return first < m_outputs.size() ? &m_outputs[first] : nullptr;
}

void CommandFiles::note(const Output& output) {
    for (const std::string& key : output.keys) {
        m_outputOf.emplace(key,
                           m_outputs.size()); // the first of a sequence that has several names of one file
    }
    m_outputs.push_back(output);
}

void CommandFiles::notePresent(const std::string& option, const fs::path& path) {
    if (!isSpecial(path)) {
        const Output output{option, path, keysOf(path)};
        requireApart(output);
        note(output);
    }
}

void CommandFiles::requireApart(const Output& output) const {
    for (const std::string& key : output.keys) {
        if (m_inputs.contains(key)) {
            refuseRead(output.path, output.option);
        }
    }
    const fs::path file = output.keys.front();
    for (const Folder& folder : m_folders) {
        const bool isInside = file.parent_path() == folder.path && folder.isWritten(file.filename().string());
        if (folder.option != output.option && (file == folder.path || isInside)) {
            refuseBoth(output.path, folder.option, output.option);
        }
    }
}

} // namespace cdr::cli
