#include "command_files.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <output/gnuplot.h>

namespace cdr::cli {

namespace {

namespace fs = std::filesystem;

/// With links followed as far as there are files.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path.lexically_normal() : whole;
}

/// By name, or as two names of one file.
bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return resolved(a) == resolved(b) || fs::equivalent(a, b, error);
}

/// The same of names that may be many: only where they end alike are links followed.
bool isSameName(const fs::path& a, const fs::path& b) {
    return a.filename() == b.filename() && isSame(a, b);
}

[[noreturn]] void refuseBoth(const fs::path& path, const std::string& first, const std::string& second) {
    throw base::InputError(fmt::format("{}: both {} and {} would write it", path.string(), first, second));
}

/// Whether there is something at the path that is no regular file, such as a device.
bool isSpecial(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

} // namespace

void CommandFiles::reads(const fs::path& path) {
    m_inputs.push_back(path);
    for (const Output& output : m_outputs) {
        requireApart(output);
    }
}

void CommandFiles::writes(const std::string& option, const fs::path& path) {
    platform::requireWritable(path);
    if (isSpecial(path)) {
        return;
    }
    const Output output{option, path};
    requireApart(output);
    for (const Output& other : m_outputs) {
        if (isSame(other.path, path)) {
            refuseBoth(path, other.option, option);
        }
    }
    for (const Sequence& sequence : m_sequences) {
        for (std::size_t number = sequence.begin; number < sequence.end; ++number) {
            if (isSameName(sequence.nameAt(number), path)) {
                refuseBoth(path, sequence.option, option);
            }
        }
    }
    m_outputs.push_back(output);
}

void CommandFiles::mayWrite(const std::string& option, const fs::path& path) {
    if (!path.empty()) {
        writes(option, path);
    }
}

void CommandFiles::mayPlot(const fs::path& path) {
    if (!path.empty()) {
        output::requirePlottable(path);
        writes("--plot", path);
    }
}

void CommandFiles::writesSequence(const std::string& option, std::size_t begin, std::size_t end,
                                  const std::function<fs::path(std::size_t)>& nameAt) {
    const std::vector<Output> others = m_outputs;
    m_sequences.push_back({option, begin, end, nameAt});
    for (std::size_t number = begin; number < end; ++number) {
        const Output output{option, nameAt(number)};
        for (const Output& other : others) {
            if (other.option != option && isSameName(output.path, other.path)) {
                refuseBoth(output.path, other.option, option);
            }
        }
        std::error_code error;
        if (fs::exists(output.path, error) && !isSpecial(output.path)) { // else nothing is lost
            requireUnread(output);
            m_outputs.push_back(output); // for what is read later
        }
    }
}

void CommandFiles::writesPictures(const std::string& option, const fs::path& folder,
                                  const std::string& stem) {
    m_pictures.push_back({option, folder, stem});
    for (const Output& output : m_outputs) {
        requireApart(output);
    }
}

void CommandFiles::requireUnread(const Output& output) const {
    for (const fs::path& input : m_inputs) {
        if (isSame(input, output.path)) {
            throw base::InputError(fmt::format("{}: {} would replace what the command reads",
                                               output.path.string(), output.option));
        }
    }
}

void CommandFiles::requireApart(const Output& output) const {
    requireUnread(output);
    for (const Pictures& pictures : m_pictures) {
        const fs::path file = resolved(output.path);
        if (file.parent_path() == resolved(pictures.folder / "x").parent_path() &&
            file.extension() == ".png" && file.filename().string().starts_with(pictures.stem)) {
            refuseBoth(output.path, pictures.option, output.option);
        }
    }
}

} // namespace cdr::cli
