#include "render_results.h"

#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <output/frame_notes.h>
#include <runs/units.h>

#include <utility>
#include <vector>

namespace cdr::cli {

namespace {

/// What differs from what was asked, in words.
/// @param index of the frame, counted from the run's first.
std::vector<std::string> notesOn(Command& command, std::size_t index, const FrameOutput& made) {
    const render::Frame& frame = made.frame();
    const bool isFirst = index == 0;
    std::vector<std::string> notes;
    if (const auto& refusal = frame.stats.translucency.refusal) {
        const std::string why =
            output::noteOn(*refusal, command.device().info().name, frame.width(), frame.height());
        notes.push_back(fmt::format("frame {} drawn with --translucency weighted: {}", made.number(), why));
    }
    if (isFirst && frame.stats.lostEmission) {
        notes.push_back(fmt::format("not drawn as requested: {}", output::noteOnLostEmission()));
    }
    if (isFirst && frame.stats.lostMetallicRoughness) {
        notes.push_back(fmt::format("not drawn as requested: {}", output::noteOnLostMetallicRoughness()));
    }
    return notes;
}

} // namespace

RenderResults::RenderResults(Command& command, const RenderArguments& arguments,
                             const render::RenderOptions& options, const options::ViewsPlan& views,
                             const SequenceName& name, const options::FrameCameras& cameras)
    : m_command(command),
      m_arguments(arguments),
      m_options(options),
      m_views(views),
      m_name(name),
      m_cameras(cameras),
      m_technique(techniqueOf(arguments).name),
      m_columns(renderColumns({.hash = arguments.hash, .certificate = !arguments.certify.empty()})),
      m_table(output::tableOf(m_columns, std::vector<RenderRow>())),
      m_document(command.makeDocument(optionsJson(arguments, options.technique))) {
    if (!arguments.certify.empty()) {
        m_certificates.emplace(arguments.certify, command, optionsJson(arguments, options.technique));
    }
    if (arguments.state.empty()) {
        return;
    }
    command.sayKept(arguments.state);
    if (command.ranks().isFirst()) {
        m_kept.emplace(
            arguments.state, runs::UnitRun{.digest = command.digestOfRun(), .units = cameras.frames},
            KeptFrames::Shape{.frame = [this](std::size_t frame) { return shapeOf(frame); },
                              .picture = [this](std::size_t frame) { return m_name.at(numberOf(frame)); }});
        if (m_kept->count() > 0) {
            command.console().line(fmt::format("{} of {} frames are kept in {}", m_kept->count(),
                                               cameras.frames, arguments.state.string()));
        }
    }
}

std::vector<std::size_t> RenderResults::missing() {
    std::vector<std::uint32_t> frames;
    for (std::uint32_t frame = 0; frame < m_cameras.frames; ++frame) {
        if (!m_kept || !m_kept->has(frame)) {
            frames.push_back(frame);
        }
    }
    if (!m_arguments.state.empty()) { // which the first rank alone has read
        frames = runs::sharedOf(m_command.ranks(), frames);
    }
    return {frames.begin(), frames.end()};
}

output::Json RenderResults::describe(std::size_t frame, const FrameOutput& made) {
    const std::string hash = m_arguments.hash || m_command.output().json || !m_arguments.state.empty()
                                 ? made.hash(m_arguments.aov)
                                 : "";
    const RenderRow row{made,
                        m_options,
                        m_views,
                        m_arguments.scene,
                        m_technique,
                        hash,
                        scene::secondsAt(m_arguments.choice, made.number())};
    const auto& certified = made.certified();
    const bool isWritten = !m_arguments.file.empty() && !(certified && certified->certificate.isRefused());
    return output::Json{
        {"notes", notesOn(m_command, frame, made)},
        {"row", output::jsonOf(m_columns, row)},
        {"cells", output::cellsOf(m_columns, row)},
        {"certificate",
         certified ? certificateOf(made.number(), made.frame().camera, *certified, made.hash(m_arguments.aov))
                   : output::Json()},
        {"file", isWritten ? output::Json::binary(made.encoded(m_name.at(made.number()), m_arguments.aov))
                           : output::Json()}};
}

void RenderResults::take(std::size_t frame, output::Json made) {
    addKept(frame);
    if (!made.at("file").is_null()) {
        platform::writeFile(m_name.at(numberOf(frame)), made.at("file").get_binary());
    }
    if (m_kept) {
        m_kept->keep(frame, made);
    }
    add(made);
}

std::uint32_t RenderResults::numberOf(std::size_t frame) const {
    return m_cameras.first + static_cast<std::uint32_t>(frame);
}

FrameShape RenderResults::shapeOf(std::size_t frame) const {
    FrameShape shape{.number = numberOf(frame),
                     .label = labelOf(m_arguments.scene, numberOf(frame)),
                     .cells = m_table.header.size(),
                     .fields = {},
                     .isCertified = m_certificates.has_value()};
    for (const auto& column : m_columns) {
        if (!column.key.empty()) {
            shape.fields.insert(column.key);
        }
    }
    return shape;
}

void RenderResults::addKept(std::size_t before) {
    for (; m_kept && m_added < before; ++m_added) {
        if (m_kept->has(m_added)) {
            add(m_kept->at(m_added));
        }
    }
}

void RenderResults::add(const output::Json& made) {
    for (const output::Json& note : made.at("notes")) {
        m_command.console().line(note.get<std::string>());
    }
    if (m_certificates) {
        m_certificates->add(made.at("certificate"));
    }
    m_document["results"].push_back(made.at("row"));
    m_table.rows.push_back(made.at("cells").get<std::vector<std::string>>());
}

void RenderResults::finish(const std::string& written) {
    addKept(m_cameras.frames);
    const Console& console = m_command.console();
    console.table(m_table);
    console.line(m_command.opened().text());
    if (!m_certificates || !m_certificates->hasRefused()) {
        console.line(written);
    }
    m_command.writeDocument(std::move(m_document));
    if (m_certificates && m_command.ranks().isFirst()) {
        m_certificates->finish();
    }
}

} // namespace cdr::cli
