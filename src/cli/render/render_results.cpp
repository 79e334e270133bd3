#include "render_results.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <output/frame_notes.h>
#include <program/sha256.h>
#include <runs/kept_ranks.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
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

/// A frame as a state keeps it, since its picture is in a file of its own.
platform::Bytes withoutPicture(const platform::Bytes& bytes) {
    auto made = output::Json::from_cbor(bytes);
    const output::Json file = std::move(made.at("file"));
    made.erase("file");
    made["picture"] = file.is_null() ? output::Json() : output::Json(program::sha256(file.get_binary()));
    return output::Json::to_cbor(made);
}

/// Whether no text that a state holds controls a terminal, since many are printed.
/// @param label has bytes of the scene's name.
bool isPrintable(const output::Json& json, const std::string& label) {
    if (json.is_structured()) {
        const auto items = json.items();
        return std::all_of(items.begin(), items.end(), [&](const auto& item) {
            return platform::oneLine(item.key()) == item.key() && isPrintable(item.value(), label);
        });
    }
    return !json.is_string() || json == label || platform::oneLine(json.get<std::string>()) == json;
}

/// Whether CertificateFile can say of this certificate that the frame was refused.
bool isRefusal(const output::Json& certificate) {
    const output::Json& first = certificate.at("first_refused");
    constexpr auto kMost = std::numeric_limits<std::uint32_t>::max();
    const auto isCount = [](const output::Json& json) { return json.is_number_unsigned() && json <= kMost; };
    return isCount(certificate.at("frame")) && certificate.at("refused").is_number_unsigned() &&
           isCount(first.at(0)) && isCount(first.at(1));
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
    if (runs::KeptRanks* kept = command.keptRanks(); kept != nullptr) {
        takeUp(*kept);
    }
}

void RenderResults::takeUp(runs::KeptRanks& kept) const {
    kept.keepAs(withoutPicture);
    kept.keepOnly([&](std::size_t frame, const platform::Bytes& bytes) {
        const auto made = output::Json::from_cbor(bytes);
        requireTakable(frame, made);
        return hasPicture(made, m_name.at(numberOf(frame)));
    });
    if (kept.keptCount() > 0) {
        m_command.console().line(fmt::format("{} of {} frames are kept in {}", kept.keptCount(),
                                             m_cameras.frames, m_arguments.state.string()));
    }
}

void RenderResults::requireTakable(std::size_t frame, const output::Json& made) const {
    using Texts = std::vector<std::string>;
    made.at("notes").get<Texts>();
    const output::Json& certificate = made.at("certificate");
    const bool isTakable = frame < m_cameras.frames && made.at("row").is_object() &&
                           made.at("cells").get<Texts>().size() == m_table.header.size() &&
                           certificate.is_object() == m_certificates.has_value() &&
                           isPrintable(made, labelOf(m_arguments.scene, numberOf(frame))) &&
                           (!certificate.contains("first_refused") || isRefusal(certificate));
    if (!isTakable) {
        throw std::out_of_range("no frame of this run");
    }
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

void RenderResults::take(std::size_t frame, const output::Json& made) {
    if (!made.contains("picture") && !made.at("file").is_null()) {
        platform::writeFile(m_name.at(numberOf(frame)), made.at("file").get_binary());
    }
    for (const output::Json& note : made.at("notes")) {
        m_command.console().line(note.get<std::string>());
    }
    if (m_certificates) {
        m_certificates->add(made.at("certificate"));
    }
    m_document["results"].push_back(made.at("row"));
    m_table.rows.push_back(made.at("cells").get<std::vector<std::string>>());
}

std::uint32_t RenderResults::numberOf(std::size_t frame) const {
    return m_cameras.first + static_cast<std::uint32_t>(frame);
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
