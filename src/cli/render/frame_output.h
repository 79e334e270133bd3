#pragma once

#include "certificate_file.h"

#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/file.h>
#include <cdr/render/renderer.h>

#include <options/views/views_plan.h>
#include <output/aov.h>
#include <output/columns.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cdr::cli {

/// A frame that `render` has made, on its way into a file, a hash, JSON and the table.
class FrameOutput {
  public:
    /// @param truth of the same camera and size; Aov::wrong needs it.
    /// @param certified of the frame, which has its repairs.
    FrameOutput(std::uint32_t number, render::Frame frame, std::optional<measure::TruthImage> truth,
                std::optional<CertifiedOutput> certified);

    std::uint32_t number() const { return m_number; }
    const render::Frame& frame() const { return m_frame; }

    /// The file that it is written as: .png, .tga or .exr.
    platform::Bytes encoded(const std::filesystem::path& path, output::Aov aov) const;
    std::string hash(output::Aov aov) const { return hashOf(m_frame, aov, truth()); }
    /// Where there is a truth.
    const std::optional<measure::WrongPixels>& wrong() const { return m_wrong; }
    /// Where a certificate was asked for.
    const std::optional<CertifiedOutput>& certified() const { return m_certified; }

  private:
    const measure::TruthImage* truth() const { return m_truth ? &*m_truth : nullptr; }

    std::uint32_t m_number;
    render::Frame m_frame;
    std::optional<measure::TruthImage> m_truth;
    std::optional<measure::WrongPixels> m_wrong;
    std::optional<CertifiedOutput> m_certified;
};

/// A row of what `render` prints and of its JSON.
struct RenderRow {
    const FrameOutput& made;
    const render::RenderOptions& options;
    const options::ViewsPlan& views;
    std::string scene;
    std::string technique;
    std::string hash;
    std::optional<double> seconds; ///< of the animation that is played
};

/// What the table has beside the rest; JSON has it always.
struct RenderHeadings {
    bool hash = false;
    bool certificate = false;
};

/// The first cell of a frame's row: "cubes frame 3".
std::string labelOf(const std::string& scene, std::uint32_t number);

output::Columns<RenderRow> renderColumns(const RenderHeadings& shown);

} // namespace cdr::cli
