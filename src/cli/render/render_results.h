#pragma once

#include "../command.h"
#include "certificate_file.h"
#include "frame_output.h"
#include "render_arguments.h"
#include "sequence_name.h"

#include <options/camera_options.h>
#include <options/views/views_plan.h>
#include <output/columns.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

/// What `render` gives out: pictures, rows of the table and of JSON, a certificate. Any rank describes a frame; the first
/// takes what was described, in order.
class RenderResults {
  public:
    /// @param options as the frames are drawn. What is given by reference must outlive the results.
    RenderResults(Command& command, const RenderArguments& arguments, const render::RenderOptions& options,
                  const options::ViewsPlan& views, const SequenceName& name,
                  const options::FrameCameras& cameras);

    /// All of a frame that take() needs.
    /// @param frame counted from the run's first, which says what is not drawn as requested.
    output::Json describe(std::size_t frame, const FrameOutput& made);
    /// Writes the picture, unless an earlier run did, and keeps the rows.
    /// @param frame counted from the run's first.
    void take(std::size_t frame, const output::Json& made);
    /// Prints the table and writes JSON and the certificate. ExitStatus::kFound where a frame was refused.
    /// @param written what became of the pictures, in words.
    void finish(const std::string& written);

  private:
    std::uint32_t numberOf(std::size_t frame) const;
    /// Takes up the frames of --state whose pictures are there.
    void takeUp(runs::KeptRanks& kept) const;
    /// std::out_of_range or Json::exception where take() would not take what a state holds.
    void requireTakable(std::size_t frame, const output::Json& made) const;

    Command& m_command;
    const RenderArguments& m_arguments;
    const render::RenderOptions& m_options;
    const options::ViewsPlan& m_views;
    const SequenceName& m_name;
    const options::FrameCameras& m_cameras;
    std::string m_technique;
    std::optional<CertificateFile> m_certificates;
    output::Columns<RenderRow> m_columns;
    output::Table m_table;
    nlohmann::ordered_json m_document;
};

} // namespace cdr::cli
