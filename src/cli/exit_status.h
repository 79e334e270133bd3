#pragma once

#include <exception>

namespace cdr::cli {

/// Thrown by a command that did its work, and wrote all of it, to end the program with another status than 0.
class ExitStatus : public std::exception {
  public:
    /// A check that was asked for found what it does not allow.
    static constexpr int kFound = 3;

    explicit ExitStatus(int status) : m_status(status) {}
    int status() const { return m_status; }
    const char* what() const noexcept override { return "a check did not pass"; }

  private:
    int m_status;
};

} // namespace cdr::cli
