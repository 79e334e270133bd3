#pragma once

#include <cdr/scene/gltf/import_progress.h>

#include <cstdint>
#include <optional>

namespace cdr::scene::gltf {

/// A picture counts as so many bytes, which take about as long to read.
inline constexpr std::uint64_t kPictureBytes = std::uint64_t{4} << 20u;

/// How far an import is, in bytes. An import is a row of steps, and each step foretells about how many bytes it reads. One
/// thread at a time calls it.
class ReadProgress {
  public:
    /// @param tell may be empty. @param all bytes of all steps.
    ReadProgress(ImportProgress tell, std::uint64_t all);

    /// Ends the step before, read or not, and begins one of so many bytes.
    void begin(std::uint64_t bytes);
    /// So many bytes were read. What a step reads beyond what it foretold does not count.
    void read(std::uint64_t bytes);
    /// Tells where it is, unless that was told last.
    void tell();

  private:
    ImportProgress m_tell;
    std::uint64_t m_all;
    std::uint64_t m_done = 0;
    std::uint64_t m_end = 0;             ///< of the step
    std::uint64_t m_next = 0;            ///< from where on it is told again
    std::optional<std::uint64_t> m_told; ///< last
};

} // namespace cdr::scene::gltf
