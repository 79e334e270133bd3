#include "frame_output.h"

#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <output/wrong_pixels_columns.h>

#include <utility>

namespace cdr::cli {

FrameOutput::FrameOutput(std::uint32_t number, render::Frame frame, std::optional<measure::TruthImage> truth,
                         std::optional<CertifiedOutput> certified)
    : m_number(number),
      m_frame(std::move(frame)),
      m_truth(std::move(truth)),
      m_certified(std::move(certified)) {
    if (m_truth) {
        m_wrong = measure::countWrong(m_frame.ids(), *m_truth);
    }
}

platform::Bytes FrameOutput::encoded(const std::filesystem::path& path, output::Aov aov) const {
    return platform::lowerExtension(path) == ".exr"
               ? image::encodeExr(path, output::channelsOf(m_frame, aov, truth()))
               : image::encodeImage(path, output::pictureOf(m_frame, aov, truth()));
}

std::string labelOf(const std::string& scene, std::uint32_t number) {
    return fmt::format("{} frame {}", scene, number);
}

output::Columns<RenderRow> renderColumns(const RenderHeadings& shown) {
    const auto ofStats = [](auto member) {
        return [member](const RenderRow& row) { return row.made.frame().stats.*member; };
    };
    const auto ofTimes = [](auto member) {
        return [member](const RenderRow& row) { return row.made.frame().stats.times.*member; };
    };
    // A surface path that is not the default is named as `timing --modes` does.
    const auto techniqueText = [](const RenderRow& row) {
        return row.options.surface == render::SurfacePath::gbuffer
                   ? row.technique
                   : fmt::format("{}/{}", row.technique, nameOf(row.options.surface));
    };
    output::Columns<RenderRow> columns{
        {.heading = "scene",
         .text = [](const RenderRow& row) { return labelOf(row.scene, row.made.number()); }},
        {.key = "technique", .value = &RenderRow::technique, .heading = "technique", .text = techniqueText},
        {.key = "targets", .value = [](const RenderRow& row) { return nameOf(row.options.targets.kind); }},
        {.key = "layers", .value = [](const RenderRow& row) { return row.options.targets.layers; }},
        {.key = "submission", .value = [](const RenderRow& row) { return nameOf(row.options.submission); }},
        {.key = "batching", .value = [](const RenderRow& row) { return nameOf(row.options.batching); }},
        {.key = "surface", .value = [](const RenderRow& row) { return nameOf(row.options.surface); }},
        {.key = "detail", .value = [](const RenderRow& row) { return nameOf(row.options.detail); }},
        {.key = "views", .value = [](const RenderRow& row) { return row.views.count(); }},
        {.key = "stereo", .value = [](const RenderRow& row) { return row.views.stereoName(); }},
        {.key = "threads", .value = [](const RenderRow& row) { return row.options.threads; }},
        {.key = "cascades",
         .value = [](const RenderRow& row) { return row.made.frame().cascades.size(); },
         .heading = "cascades"},
        {.key = "draws", .value = ofStats(&render::FrameStats::draws), .heading = "draws"},
        {.key = "hash", .value = &RenderRow::hash},
        {.key = "frame", .value = [](const RenderRow& row) { return row.made.number(); }},
        {.key = "seconds",
         .value =
             [](const RenderRow& row) {
                 return row.seconds ? output::Json(*row.seconds) : output::absent();
             }},
        {.key = "visible", .value = ofStats(&render::FrameStats::visible)},
        {.key = "duplication", .value = ofStats(&render::FrameStats::duplication)},
        {.key = "occluder_draws",
         .value = [](const RenderRow& row) { return row.made.frame().stats.occluders.draws; }},
        {.key = "hidden",
         .value = [](const RenderRow& row) { return row.made.frame().stats.occluders.hidden; }},
        {.key = "shadows", .value = [](const RenderRow& row) { return nameOf(row.options.shadows.method); }},
        {.key = "shadow_maps",
         .value = [](const RenderRow& row) { return row.made.frame().stats.shadows.maps; }},
        {.key = "shadow_casters",
         .value = [](const RenderRow& row) { return row.made.frame().stats.shadows.casters; }},
        {.key = "shadows_ms", .value = ofTimes(&render::FrameTimes::shadowsMs)},
        {.key = "cull_ms", .value = ofTimes(&render::FrameTimes::cullMs)},
        {.key = "split_ms", .value = ofTimes(&render::FrameTimes::splitMs)},
        {.key = "occluders_ms", .value = ofTimes(&render::FrameTimes::occludersMs)},
        {.key = "bin_ms", .value = ofTimes(&render::FrameTimes::binMs)},
        {.key = "translucency",
         .value = [](const RenderRow& row) { return nameOf(row.made.frame().stats.translucency.method); }},
        {.key = "translucent_draws",
         .value = [](const RenderRow& row) { return row.made.frame().stats.translucency.draws; }},
        {.key = "translucent_bytes",
         .value = [](const RenderRow& row) { return row.made.frame().stats.translucency.bytes; }},
        {.key = "translucent_ms", .value = ofTimes(&render::FrameTimes::translucentMs)},
        {.key = "record_ms", .value = ofTimes(&render::FrameTimes::recordMs), .heading = "record ms"},
        {.key = "execute_ms", .value = ofTimes(&render::FrameTimes::executeMs), .heading = "execute ms"}};
    const auto wrong = output::columnsOf<RenderRow>([](const RenderRow& row) { return row.made.wrong(); },
                                                    output::wrongPixelsColumns({.share = "wrong"}));
    const auto certificate = output::columnsOf<RenderRow>(
        [](const RenderRow& row) {
            const auto& certified = row.made.certified();
            return certified ? &certified->certificate : nullptr;
        },
        certificateColumns(shown.certificate));
    columns = output::joined<RenderRow>({columns, wrong, certificate});
    columns.push_back({.key = "certify_ms",
                       .value =
                           [](const RenderRow& row) {
                               const auto& certified = row.made.certified();
                               return certified ? output::Json(certified->milliseconds) : output::absent();
                           },
                       .heading = shown.certificate ? "certify ms" : ""});
    if (shown.hash) {
        columns.push_back({.heading = "sha-256", .text = &RenderRow::hash});
    }
    return columns;
}

} // namespace cdr::cli
