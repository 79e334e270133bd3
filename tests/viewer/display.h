#pragma once

#include <cstdio>
#include <string>

namespace cdr::viewer_test {

/// An X server without a screen, 3840x2160, on a display number that was free.
class Display {
  public:
    /// Waits until it takes clients.
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// "DISPLAY=:7", as typed before a command.
    std::string environment() const { return "DISPLAY=:" + m_number; }

  private:
    std::FILE* m_server = nullptr;
    int m_process = 0;
    std::string m_number;
};

} // namespace cdr::viewer_test
