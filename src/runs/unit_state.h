#pragma once

#include <output/columns.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace cdr::runs {

/// What a state holds.
struct UnitState {
    std::map<std::size_t, output::Json> made{}; ///< results by unit
    std::uintmax_t bytes = 0; ///< of the text; behind them lies what was cut off as it was written
};

// A state is lines of text. One says of which run it is, by a digest of everything that results depend on. There is one for each
// result, which begins with its SHA-256.
std::string stateHeadOf(std::string_view digest);
std::string stateLineOf(std::size_t unit, const output::Json& made);
/// A line of that text.
std::string summed(std::string_view text);

/// The state that a text holds; an empty text holds none of any run.
/// @param name of the file, which a message begins with.
/// base::InputError, in one line, for a damaged text or one of another run.
UnitState readUnitState(std::string_view text, std::string_view digest, const std::string& name);

/// Keeps results of a run's units in a file, each as soon as it is there.
class UnitStateFile {
  public:
    /// Takes up what an earlier run left. base::InputError as readUnitState(), and where the file cannot be read or written.
    UnitStateFile(std::filesystem::path path, std::string digest);

    /// Those of earlier runs.
    std::map<std::size_t, output::Json>& made() { return m_state.made; }
    /// base::RunError where it cannot be written.
    void keep(std::size_t unit, const output::Json& result);

  private:
    void begin();

    std::filesystem::path m_path;
    std::string m_digest;
    UnitState m_state;
    bool m_hasBegun = false; ///< to write
};

} // namespace cdr::runs
