#include "kept_frames.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>

#include <program/sha256.h>

#include <limits>
#include <utility>

namespace cdr::cli {

namespace {

namespace fs = std::filesystem;
using output::Json;

/// Whether the picture of a frame is there as it was written, if it has one.
bool hasPicture(const Json& made, const fs::path& path) {
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

KeptFrames::KeptFrames(const fs::path& path, runs::UnitRun run, const Shape& shape)
    : m_file(path, std::move(run)),
      m_made(m_file.made()) {
    for (const auto& [frame, made] : m_made) {
        if (!isKeptFrame(made, shape.frame(frame))) {
            throw base::inputError("{}: holds no results of render; remove it or name another file",
                                   path.string());
        }
    }
    std::erase_if(m_made,
                  [&](const auto& kept) { return !hasPicture(kept.second, shape.picture(kept.first)); });
}

void KeptFrames::keep(std::size_t frame, Json made) {
    const Json& file = made.at("file");
    made["picture"] = file.is_null() ? Json() : Json(program::sha256(file.get_binary()));
    made.erase("file");
    m_file.keep(frame, made);
}

} // namespace cdr::cli
