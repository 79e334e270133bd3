#include "frame_output.h"

#include <experiments/wrong_pixels_columns.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>

namespace cdr::cli {

FrameOutput::FrameOutput(std::uint32_t number, render::Frame frame, std::optional<measure::TruthImage> truth)
    : m_number(number),
      m_frame(std::move(frame)),
      m_truth(std::move(truth)) {
    if (m_truth) {
        m_wrong = measure::countWrong(m_frame.ids(), *m_truth);
    }
}

void FrameOutput::write(const std::filesystem::path& path, experiments::Aov aov) const {
    if (path.extension() == ".exr") {
        image::writeExr(path, experiments::channelsOf(m_frame, aov, truth()));
    } else {
        image::writeImage(path, experiments::pictureOf(m_frame, aov, truth()));
    }
}

nlohmann::ordered_json FrameOutput::toJson(const std::string& technique, const render::RenderOptions& options,
                                           const std::string& hash) const {
    const render::FrameStats& stats = m_frame.stats;
    nlohmann::ordered_json row{{"technique", technique},
                               {"targets", nameOf(options.targets.kind)},
                               {"layers", options.targets.layers},
                               {"submission", nameOf(options.submission)},
                               {"batching", nameOf(options.batching)},
                               {"detail", nameOf(options.detail)},
                               {"threads", options.threads},
                               {"cascades", m_frame.cascades.size()},
                               {"draws", stats.draws},
                               {"hash", hash},
                               {"frame", m_number},
                               {"visible", stats.visible},
                               {"duplication", stats.duplication},
                               {"cull_ms", stats.times.cullMs},
                               {"bin_ms", stats.times.binMs},
                               {"translucency", nameOf(stats.translucency.method)},
                               {"translucent_draws", stats.translucency.draws},
                               {"translucent_bytes", stats.translucency.bytes},
                               {"record_ms", stats.times.recordMs},
                               {"execute_ms", stats.times.executeMs}};
    if (m_wrong) {
        row.update(experiments::jsonOf(experiments::wrongPixelsColumns(), *m_wrong));
    }
    return row;
}

std::vector<std::string> FrameOutput::tableHeader() {
    return {"scene", "technique", "cascades", "draws", "record ms", "execute ms", "wrong"};
}

std::vector<std::string> FrameOutput::tableRow(const std::string& scene, const std::string& technique) const {
    const render::FrameStats& stats = m_frame.stats;
    return {fmt::format("{} frame {}", scene, m_number),
            technique,
            std::to_string(m_frame.cascades.size()),
            std::to_string(stats.draws),
            fmt::format("{:.2f}", stats.times.recordMs),
            fmt::format("{:.2f}", stats.times.executeMs),
            m_wrong ? fmt::format("{:.4f} %", 100.0 * m_wrong->fraction()) : ""};
}

} // namespace cdr::cli
