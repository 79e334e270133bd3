#include "unit_state.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>

#include <fmt/format.h>
#include <program/sha256.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace cdr::runs {

namespace {

constexpr std::uintmax_t kMaxStateBytes = std::uintmax_t{1} << 30u;
constexpr std::string_view kStateName = "cdr state 1 ";
constexpr std::size_t kDigits = 64; ///< of a SHA-256
constexpr int kDeepest = 8;         ///< of nested values

bool isThere(const std::filesystem::path& path) {
    std::error_code error; // readFile() says what is wrong with a file that may be there
    return std::filesystem::status(path, error).type() != std::filesystem::file_type::not_found;
}

/// A line of stateLineOf(), without its end.
void readLine(std::string_view line, UnitState& state) {
    const std::string_view json = line.substr(std::min(line.size(), kDigits + 1));
    if (json.empty() || line.substr(0, kDigits + 1) != program::sha256Of(json) + " ") {
        throw base::InputError("is damaged");
    }
    auto record = platform::parseShallow<output::Json>(json, kDeepest, "is damaged");
    const output::Json& unit = record.at("unit");
    if (!unit.is_number_unsigned()) {
        throw base::InputError("is damaged");
    }
    state.made[unit.get<std::size_t>()] = std::move(record.at("made"));
}

UnitState parseState(std::string_view text, std::string_view digest) {
    UnitState state;
    if (text.empty()) {
        return state;
    }
    const std::string head = stateHeadOf(digest);
    if (!text.starts_with(kStateName)) {
        throw base::InputError("is no state");
    }
    if (!text.starts_with(head)) {
        throw base::InputError(
            "is the state of a run with other options or files, another version or device");
    }
    state.bytes = head.size();
    for (std::size_t end = 0; (end = text.find('\n', state.bytes)) != std::string_view::npos;
         state.bytes = end + 1) {
        readLine(text.substr(state.bytes, end - state.bytes), state);
    }
    return state;
}

} // namespace

std::string stateHeadOf(std::string_view digest) {
    return fmt::format("{}{}\n", kStateName, digest);
}

std::string stateLineOf(std::size_t unit, const output::Json& made) {
    const std::string json = output::Json{{"unit", unit}, {"made", made}}.dump(
        -1, ' ', false, output::Json::error_handler_t::replace);
    return summed(json);
}

std::string summed(std::string_view text) {
    return fmt::format("{} {}\n", program::sha256Of(text), text);
}

UnitState readUnitState(std::string_view text, std::string_view digest, const std::string& name) {
    std::string what;
    try {
        return parseState(text, digest);
    } catch (const nlohmann::json::exception&) {
        what = "is damaged";
    } catch (const base::InputError& error) {
        what = error.what();
    }
    throw base::inputError("{}: {}; remove it or name another file", name, what);
}

UnitStateFile::UnitStateFile(std::filesystem::path path, std::string digest)
    : m_path(std::move(path)),
      m_digest(std::move(digest)) {
    if (isThere(m_path)) {
        const platform::Bytes bytes = platform::readFile(m_path, kMaxStateBytes);
        m_state = readUnitState({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, m_digest,
                                m_path.string());
    }
    if (m_state.bytes == 0) { // begin() writes a whole file
        platform::requireWritable(m_path);
    } else if (!std::ofstream(m_path, std::ios::binary | std::ios::app)) {
        throw base::InputError(m_path.string() + ": cannot be written");
    }
}

void UnitStateFile::keep(std::size_t unit, const output::Json& result) {
    if (!std::exchange(m_hasBegun, true)) {
        begin();
    }
    platform::appendText(m_path, stateLineOf(unit, result));
}

void UnitStateFile::begin() {
    if (m_state.bytes == 0) {
        platform::writeText(m_path, stateHeadOf(m_digest)); // whole, so that a head is never cut off
        return;
    }
    std::error_code error;
    std::filesystem::resize_file(m_path, m_state.bytes, error);
    if (error) {
        throw base::runError("{}: write failed: {}", m_path.string(), error.message());
    }
}

} // namespace cdr::runs
