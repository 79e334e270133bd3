#pragma once

#include "bytes/files.h"
#include "notes.h"

#include <nlohmann/json.hpp>

namespace cdr::scene::gltf {

/// What the importer modules share. Files count what is read of them, and notes are added; the rest does not change.
struct Sources {
    const nlohmann::json& document; ///< parseDocument()
    const Buffers& buffers;
    Files& files;
    Notes& notes;
};

} // namespace cdr::scene::gltf
