#pragma once

#include "../command.h"

#include <cdr/measure/certify/certifier.h>
#include <cdr/scene/camera.h>

#include <nlohmann/json.hpp>
#include <output/columns.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace cdr::cli {

/// What is certified of a frame, and what that took.
struct CertifiedOutput {
    measure::Certificate certificate;
    double snapPixels = 0.0; ///< measure::DrawnFrame::snapPixels
    double milliseconds = 0.0;
};

/// What a certificate counts. Null stands for what rays found of a frame that was refused: none was cast.
/// @param isShown whether tables have some of it.
output::Columns<measure::Certificate> certificateColumns(bool isShown);

/// A frame's part of a certificate file.
/// @param hash of the picture's values, as `render --hash` prints it.
nlohmann::ordered_json certificateOf(std::uint32_t number, const scene::Camera& camera,
                                     const CertifiedOutput& certified, const std::string& hash);

/// The file that `render --certify` writes: what all JSON of the program begins with, the rule and the bound, and a result
/// for each frame.
class CertificateFile {
  public:
    /// @param options of the command's JSON. The device must be open.
    CertificateFile(std::filesystem::path path, Command& command, nlohmann::ordered_json options);

    /// Adds a certificateOf(), and warns where it refuses the frame.
    void add(nlohmann::ordered_json certificate);
    /// Whether a frame was refused.
    bool hasRefused() const { return m_refused > 0; }
    /// Writes the file. ExitStatus::kFound, after that, where a frame was refused.
    void finish();

  private:
    std::filesystem::path m_path;
    const Console& m_console;
    nlohmann::ordered_json m_document;
    std::size_t m_refused = 0; ///< frames
};

} // namespace cdr::cli
