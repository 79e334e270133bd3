#pragma once

#include <output/columns.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

namespace cdr::cli {

/// What a frame is like that the state of a run keeps.
struct FrameShape {
    std::uint32_t number = 0;
    std::string label;            ///< the first cell of its row in the table, see labelOf()
    std::size_t cells = 0;        ///< of that row
    std::set<std::string> fields; ///< that its row in JSON may have; "frame" is always there
    bool isCertified = false;
};

/// Bounds of what is read. What `render` writes stays far below them.
inline constexpr std::size_t kMaxNotes = 64;
inline constexpr std::size_t kMaxText = 4096; ///< bytes of a text

/// Whether RenderResults can take what a state holds. Each value has its type and range. No text but the label has a
/// control character, since all are printed. Throws nothing, whatever `made` is.
bool isKeptFrame(const output::Json& made, const FrameShape& frame);

} // namespace cdr::cli
