#include "render_results.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <output/frame_notes.h>
#include <program/sha256.h>
#include <runs/units.h>

#include <limits>
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

/// Whether the picture of a frame is there as it was written, if it has one.
bool hasPicture(const output::Json& made, const std::filesystem::path& path) {
    if (made.at("picture").is_null()) {
        return true;
    }
    try {
        const platform::Bytes bytes = platform::readFile(path, std::numeric_limits<std::uintmax_t>::max());
        return program::sha256(bytes) == made.at("picture").get<std::string>();
    } catch (const base::InputError&) {
        return false;
    }
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
        takeUpKept();
    }
}

void RenderResults::takeUpKept() {
    const std::string state = m_arguments.state.string();
    auto& kept = m_kept
                     .emplace(m_arguments.state,
                              runs::UnitRun{.digest = m_command.digestOfRun(), .units = m_cameras.frames})
                     .made();
    for (const auto& [frame, made] : kept) {
        if (!isKeptFrame(made, shapeOf(frame))) {
            throw base::inputError("{}: holds no results of render; remove it or name another file", state);
        }
    }
    std::erase_if(
        kept, [&](const auto& frame) { return !hasPicture(frame.second, m_name.at(numberOf(frame.first))); });
    if (!kept.empty()) {
        m_command.console().line(
            fmt::format("{} of {} frames are kept in {}", kept.size(), m_cameras.frames, state));
    }
}

std::vector<std::size_t> RenderResults::missing() {
    std::vector<std::uint32_t> frames;
    for (std::uint32_t frame = 0; frame < m_cameras.frames; ++frame) {
        if (!m_kept || !m_kept->made().contains(frame)) {
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
    const output::Json& file = made.at("file");
    if (!file.is_null()) {
        platform::writeFile(m_name.at(numberOf(frame)), file.get_binary());
    }
    if (m_kept) {
        output::Json kept = made;
        kept["picture"] = file.is_null() ? output::Json() : output::Json(program::sha256(file.get_binary()));
        kept.erase("file");
        m_kept->keep(frame, kept);
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
        if (const auto kept = m_kept->made().find(m_added); kept != m_kept->made().end()) {
            add(kept->second);
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
