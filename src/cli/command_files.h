#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cdr::cli {

/// The files that one command reads and writes. None of them may be another's, or what is read would be lost.
class CommandFiles {
  public:
    /// The folder that the command makes for its pictures, which come before all its other files. Those may be in it before it
    /// is there.
    void makes(const std::filesystem::path& folder) { m_made = folder; }

    /// base::InputError when the command writes this file.
    void reads(const std::filesystem::path& path);

    /// base::InputError when the file cannot be written, or is one that the command reads, or another of its outputs.
    /// Devices, FIFOs and descriptors may take several outputs.
    /// @param option that names it, such as "--json".
    void writes(const std::string& option, const std::filesystem::path& path);

    /// The same of an option that was perhaps not given, whose path is empty then.
    void mayWrite(const std::string& option, const std::filesystem::path& path);

    /// The same of --plot. base::InputError also as output::requirePlottable().
    void mayPlot(const std::filesystem::path& path);

    /// The other pictures of a sequence, whose first one is named by writes(). base::InputError when the command reads one, or
    /// another output is one, of those noted later too.
    /// @param number of the picture that nameAt() is to name.
    void writesSequence(const std::string& option, std::size_t begin, std::size_t end,
                        const std::function<std::filesystem::path(std::size_t number)>& nameAt);

    /// Files in a folder. base::InputError when another output has the folder's name or is one of the files, or the command
    /// reads one, of those noted later too.
    /// @param isWritten whether a file may be one, by its name in the folder.
    void writesFolder(const std::string& option, const std::filesystem::path& folder,
                      const std::function<bool(const std::string& name)>& isWritten);

  private:
    struct Output {
        std::string option;
        std::filesystem::path path;
        std::vector<std::string> keys{}; ///< its canonical name, then its device and inode where it exists
    };
    struct Sequence {
        std::string option;
        std::size_t begin = 0;
        std::size_t end = 0;
        std::function<std::filesystem::path(std::size_t number)> nameAt; ///< outlives the call that gave it
    };
    struct Folder {
        std::string option;
        std::filesystem::path path; ///< its canonical name
        std::function<bool(const std::string& name)> isWritten;
    };
    bool isInMade(const std::filesystem::path& path) const;
    /// Of names that may be many: only where they end alike are links followed.
    static bool isSameName(const std::filesystem::path& path, const Output& output);
    /// The first output that is this file, or null.
    const Output* sameOutput(const std::vector<std::string>& keys) const;
    void note(const Output& output);
    /// A file that is there, for what is read later too. A device loses nothing. base::InputError when the command reads
    /// the file, or it is one of another output's folder.
    void notePresent(const std::string& option, const std::filesystem::path& path);
    void requireApart(const Output& output) const;

    std::filesystem::path m_made; ///< empty where it makes none
    std::unordered_set<std::string>
        m_inputs; ///< their keys. Links are followed once a file, as files may be many.
    std::vector<Output> m_outputs;
    std::unordered_map<std::string, std::size_t> m_outputOf; ///< by keys
    std::vector<Sequence> m_sequences;
    std::vector<Folder> m_folders;
};

} // namespace cdr::cli
