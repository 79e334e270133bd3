#pragma once

#include "bytes/files.h"
#include "document.h"
#include "notes.h"

namespace cdr::scene::gltf {

/// What the importer modules share; all is read, but files and notes note that they were.
struct Sources {
    const Document& document;
    const Buffers& buffers;
    Files& files;
    Notes& notes;
};

} // namespace cdr::scene::gltf
