#pragma once

#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <experiments/aov.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

/// A frame that `render` has made, on its way into a file, a hash, JSON and the table.
class FrameOutput {
  public:
    /// @param truth of the same camera and size; Aov::wrong needs it.
    FrameOutput(std::uint32_t number, render::Frame frame, std::optional<measure::TruthImage> truth);

    std::uint32_t number() const { return m_number; }
    const render::Frame& frame() const { return m_frame; }

    /// As .png, .tga or .exr.
    void write(const std::filesystem::path& path, experiments::Aov aov) const;
    std::string hash(experiments::Aov aov) const { return hashOf(m_frame, aov, truth()); }
    nlohmann::ordered_json toJson(const std::string& technique, const render::RenderOptions& options,
                                  const std::string& hash) const;
    /// Cells under tableHeader().
    std::vector<std::string> tableRow(const std::string& scene, const std::string& technique) const;
    static std::vector<std::string> tableHeader();

  private:
    const measure::TruthImage* truth() const { return m_truth ? &*m_truth : nullptr; }

    std::uint32_t m_number;
    render::Frame m_frame;
    std::optional<measure::TruthImage> m_truth;
    std::optional<measure::WrongPixels> m_wrong; ///< where there is a truth
};

} // namespace cdr::cli
