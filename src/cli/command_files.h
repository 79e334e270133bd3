#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cdr::cli {

/// The files that one command reads and writes. None of them may be another's, or what is read would be lost.
class CommandFiles {
  public:
    /// base::InputError when the command writes this file.
    void reads(const std::filesystem::path& path);

    /// base::InputError when the file cannot be written, or is one that the command reads, or another of its outputs.
    /// Devices, FIFOs and descriptors may take several outputs.
    /// @param option that names it, such as "--json".
    void writes(const std::string& option, const std::filesystem::path& path);

    /// Pictures in a folder: .png files whose names begin with `stem`. base::InputError when another output is one.
    void writesPictures(const std::string& option, const std::filesystem::path& folder,
                        const std::string& stem = "");

  private:
    struct Output {
        std::string option;
        std::filesystem::path path;
    };
    struct Pictures {
        std::string option;
        std::filesystem::path folder;
        std::string stem;
    };
    void requireApart(const Output& output) const;

    std::vector<std::filesystem::path> m_inputs;
    std::vector<Output> m_outputs;
    std::vector<Pictures> m_pictures;
};

} // namespace cdr::cli
