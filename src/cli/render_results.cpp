#include "render_results.h"

#include <cdr/host/file.h>
#include <experiments/frame_notes.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace cdr::cli {

namespace {

/// What differs from what was asked, in words.
std::vector<std::string> notesOn(Command& command, bool isFirst, const FrameOutput& made) {
    const render::Frame& frame = made.frame();
    std::vector<std::string> notes;
    if (const auto& refusal = frame.stats.translucency.refusal) {
        const std::string why =
            experiments::noteOn(*refusal, command.device().info().name, frame.width(), frame.height());
        notes.push_back(fmt::format("frame {} drawn with --translucency weighted: {}", made.number(), why));
    }
    if (isFirst && frame.stats.lostEmission) {
        notes.push_back(fmt::format("drawn otherwise than asked: {}", experiments::noteOnLostEmission()));
    }
    if (isFirst && frame.stats.lostShine) {
        notes.push_back(fmt::format("drawn otherwise than asked: {}", experiments::noteOnLostShine()));
    }
    return notes;
}

} // namespace

RenderResults::RenderResults(Command& command, const RenderArguments& arguments,
                             const render::RenderOptions& options, const SequenceName& name,
                             experiments::Aov aov)
    : m_command(command),
      m_arguments(arguments),
      m_options(options),
      m_name(name),
      m_aov(aov),
      m_technique(techniqueOf(arguments).name),
      m_columns(renderColumns({.hash = arguments.hash, .certificate = !arguments.certify.empty()})),
      m_table(experiments::tableOf(m_columns, std::vector<RenderRow>())),
      m_document(command.makeDocument(optionsJson(arguments, options.technique))) {
    if (!arguments.certify.empty()) {
        m_certificates.emplace(arguments.certify, command, optionsJson(arguments, options.technique));
    }
}

experiments::Json RenderResults::describe(const FrameOutput& made, bool isFirst) {
    const std::string hash = m_arguments.hash || m_command.output().json ? made.hash(m_aov) : "";
    const RenderRow row{made,        m_options, m_arguments.scene,
                        m_technique, hash,      scene::secondsAt(m_arguments.choice, made.number())};
    const auto& certified = made.certified();
    const bool isWritten = !m_arguments.file.empty() && !(certified && certified->certificate.isRefused());
    return experiments::Json{
        {"notes", notesOn(m_command, isFirst, made)},
        {"row", experiments::jsonOf(m_columns, row)},
        {"cells", experiments::cellsOf(m_columns, row)},
        {"certificate", certified
                            ? certificateOf(made.number(), made.frame().camera, *certified, made.hash(m_aov))
                            : experiments::Json()},
        {"file", isWritten ? experiments::Json::binary(made.encoded(m_name.at(made.number()), m_aov))
                           : experiments::Json()}};
}

void RenderResults::take(std::uint32_t number, experiments::Json made) {
    for (const experiments::Json& note : made.at("notes")) {
        m_command.console().line(note.get<std::string>());
    }
    if (m_certificates) {
        m_certificates->add(std::move(made.at("certificate")));
    }
    if (!made.at("file").is_null()) {
        host::writeFile(m_name.at(number), made.at("file").get_binary());
    }
    m_document["results"].push_back(std::move(made.at("row")));
    m_table.rows.push_back(made.at("cells").get<std::vector<std::string>>());
}

void RenderResults::finish(const std::string& written) {
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
