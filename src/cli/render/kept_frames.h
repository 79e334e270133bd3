#pragma once

#include "kept_frame.h"

#include <output/columns.h>
#include <runs/unit_state.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>

namespace cdr::cli {

/// The frames that earlier runs of a `render --state` have made, counted from the first of the run. Of each it has what
/// RenderResults::describe() gave. The picture is in its own file.
class KeptFrames {
  public:
    /// What frames of the run are like.
    struct Shape {
        std::function<FrameShape(std::size_t frame)> frame{};
        std::function<std::filesystem::path(std::size_t frame)> picture{};
    };

    /// base::InputError where the file is the state of another run, damaged, or cannot be read or written.
    KeptFrames(const std::filesystem::path& path, runs::UnitRun run, const Shape& shape);

    std::size_t count() const { return m_made.size(); }
    bool has(std::size_t frame) const { return m_made.contains(frame); }
    /// A frame that it has.
    const output::Json& at(std::size_t frame) const { return m_made.at(frame); }
    /// Keeps a frame whose picture is written.
    /// @param made as RenderResults::describe() gave it.
    void keep(std::size_t frame, output::Json made);

  private:
    runs::UnitStateFile m_file;
    std::map<std::size_t, output::Json>& m_made;
};

} // namespace cdr::cli
