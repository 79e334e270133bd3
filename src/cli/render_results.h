#pragma once

#include "certificate_file.h"
#include "command.h"
#include "frame_output.h"
#include "render_arguments.h"
#include "sequence_name.h"

#include <experiments/columns.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cdr::cli {

/// What `render` gives out: pictures, rows of the table and of JSON, a certificate. Any rank describes a frame; the first
/// takes what was described, in order.
class RenderResults {
  public:
    /// @param options as the frames are drawn. What is given by reference must outlive the results.
    RenderResults(Command& command, const RenderArguments& arguments, const render::RenderOptions& options,
                  const SequenceName& name, experiments::Aov aov);

    /// All of a frame that take() needs.
    /// @param isFirst whether it is the first frame of the run, which says what is drawn otherwise than asked.
    experiments::Json describe(const FrameOutput& made, bool isFirst);
    /// Writes the picture and keeps the rows.
    void take(std::uint32_t number, experiments::Json made);
    /// Prints the table and writes JSON and the certificate. ExitStatus::kFound where a frame was refused.
    /// @param written what became of the pictures, in words.
    void finish(const std::string& written);

  private:
    Command& m_command;
    const RenderArguments& m_arguments;
    const render::RenderOptions& m_options;
    const SequenceName& m_name;
    experiments::Aov m_aov;
    std::string m_technique;
    std::optional<CertificateFile> m_certificates;
    experiments::Columns<RenderRow> m_columns;
    experiments::Table m_table;
    nlohmann::ordered_json m_document;
};

} // namespace cdr::cli
