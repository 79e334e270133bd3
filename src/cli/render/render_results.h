#pragma once

#include "../command.h"
#include "certificate_file.h"
#include "frame_output.h"
#include "kept_frame.h"
#include "render_arguments.h"
#include "sequence_name.h"

#include <options/camera_options.h>
#include <options/views/views_plan.h>
#include <output/columns.h>
#include <runs/unit_state.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

/// What `render` gives out: pictures, rows of the table and of JSON, a certificate. Any rank describes a frame; the first
/// takes what was described, in order, and what earlier runs have kept of the frames between.
class RenderResults {
  public:
    /// @param options as the frames are drawn. What is given by reference must outlive the results.
    RenderResults(Command& command, const RenderArguments& arguments, const render::RenderOptions& options,
                  const options::ViewsPlan& views, const SequenceName& name,
                  const options::FrameCameras& cameras);

    /// The frames of the run, counted from its first, that are still to make; the same on all ranks, which all ask.
    std::vector<std::size_t> missing();

    /// All of a frame that take() needs.
    /// @param frame counted from the run's first, which says what is not drawn as requested.
    output::Json describe(std::size_t frame, const FrameOutput& made);
    /// Writes the picture and keeps the rows.
    /// @param frame counted from the run's first.
    void take(std::size_t frame, output::Json made);
    /// Prints the table and writes JSON and the certificate. ExitStatus::kFound where a frame was refused.
    /// @param written what became of the pictures, in words.
    void finish(const std::string& written);

  private:
    std::uint32_t numberOf(std::size_t frame) const;
    FrameShape shapeOf(std::size_t frame) const; ///< as a state must hold it
    /// Takes up the frames of --state whose pictures are there.
    void takeUpKept();
    /// Those before a frame that no take() has brought yet.
    void addKept(std::size_t before);
    void add(const output::Json& made);

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
    /// On the first rank: what describe() gave of frames that earlier runs have made. The picture is in its own file.
    std::optional<runs::UnitStateFile> m_kept;
    std::size_t m_added = 0; ///< frames
};

} // namespace cdr::cli
