#pragma once

#include <filesystem>
#include <string>

namespace cdr::cli {

/// A file name with one frame number in it, such as "out/%04d.png": %d or %0Nd, N from 1 to 9.
/// base::InputError for any other use of '%', so that no user text ever is a format string.
class SequenceName {
  public:
    explicit SequenceName(const std::string& pattern);

    bool hasNumber() const { return m_digits >= 0; }
    std::filesystem::path at(unsigned frame) const;

  private:
    std::string m_before;
    std::string m_after;
    int m_digits = -1; ///< below 0: no number
};

} // namespace cdr::cli
