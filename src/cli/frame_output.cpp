#include "frame_output.h"

#include <experiments/wrong_pixels_columns.h>

#include <fmt/format.h>

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

host::Bytes FrameOutput::encoded(const std::filesystem::path& path, experiments::Aov aov) const {
    return path.extension() == ".exr"
               ? image::encodeExr(path, experiments::channelsOf(m_frame, aov, truth()))
               : image::encodeImage(path, experiments::pictureOf(m_frame, aov, truth()));
}

experiments::Columns<RenderRow> renderColumns(bool showsHash) {
    const auto ofStats = [](auto member) {
        return [member](const RenderRow& row) { return row.made.frame().stats.*member; };
    };
    const auto ofTimes = [](auto member) {
        return [member](const RenderRow& row) { return row.made.frame().stats.times.*member; };
    };
    experiments::Columns<RenderRow> columns{
        {.heading = "scene",
         .text =
             [](const RenderRow& row) { return fmt::format("{} frame {}", row.scene, row.made.number()); }},
        {.key = "technique", .value = &RenderRow::technique, .heading = "technique"},
        {.key = "targets", .value = [](const RenderRow& row) { return nameOf(row.options.targets.kind); }},
        {.key = "layers", .value = [](const RenderRow& row) { return row.options.targets.layers; }},
        {.key = "submission", .value = [](const RenderRow& row) { return nameOf(row.options.submission); }},
        {.key = "batching", .value = [](const RenderRow& row) { return nameOf(row.options.batching); }},
        {.key = "surface", .value = [](const RenderRow& row) { return nameOf(row.options.surface); }},
        {.key = "detail", .value = [](const RenderRow& row) { return nameOf(row.options.detail); }},
        {.key = "threads", .value = [](const RenderRow& row) { return row.options.threads; }},
        {.key = "cascades",
         .value = [](const RenderRow& row) { return row.made.frame().cascades.size(); },
         .heading = "cascades"},
        {.key = "draws", .value = ofStats(&render::FrameStats::draws), .heading = "draws"},
        {.key = "hash", .value = &RenderRow::hash},
        {.key = "frame", .value = [](const RenderRow& row) { return row.made.number(); }},
        {.key = "visible", .value = ofStats(&render::FrameStats::visible)},
        {.key = "duplication", .value = ofStats(&render::FrameStats::duplication)},
        {.key = "cull_ms", .value = ofTimes(&render::FrameTimes::cullMs)},
        {.key = "bin_ms", .value = ofTimes(&render::FrameTimes::binMs)},
        {.key = "translucency",
         .value = [](const RenderRow& row) { return nameOf(row.made.frame().stats.translucency.method); }},
        {.key = "translucent_draws",
         .value = [](const RenderRow& row) { return row.made.frame().stats.translucency.draws; }},
        {.key = "translucent_bytes",
         .value = [](const RenderRow& row) { return row.made.frame().stats.translucency.bytes; }},
        {.key = "record_ms", .value = ofTimes(&render::FrameTimes::recordMs), .heading = "record ms"},
        {.key = "execute_ms", .value = ofTimes(&render::FrameTimes::executeMs), .heading = "execute ms"}};
    for (const auto& wrong : experiments::wrongPixelsColumns({.share = "wrong"})) {
        columns.push_back({.key = wrong.key,
                           .value =
                               [value = wrong.value](const RenderRow& row) {
                                   return row.made.wrong() ? value(*row.made.wrong()) : experiments::absent();
                               },
                           .heading = wrong.heading,
                           .format = wrong.format});
    }
    if (showsHash) {
        columns.push_back({.heading = "sha-256", .text = &RenderRow::hash});
    }
    return columns;
}

} // namespace cdr::cli
