#include "display.h"

#include <signal.h>

#include <array>
#include <stdexcept>

namespace cdr::viewer_test {

namespace {

std::string readLine(std::FILE* file) {
    std::array<char, 64> line{};
    if (std::fgets(line.data(), line.size(), file) == nullptr) {
        throw std::runtime_error("Xvfb did not start");
    }
    std::string text = line.data();
    text.erase(text.find_last_not_of('\n') + 1);
    return text;
}

} // namespace

Display::Display() {
    // The server writes its number once it takes clients, so reading it is all the waiting there is.
    m_server = ::popen("echo $$; exec '" CDR_XVFB
                       "' -displayfd 1 -noreset -screen 0 3840x2160x24 -nolisten tcp 2>/dev/null",
                       "r");
    if (m_server == nullptr) {
        throw std::runtime_error("no shell");
    }
    m_process = std::stoi(readLine(m_server));
    m_number = readLine(m_server);
}

Display::~Display() {
    ::kill(m_process, SIGTERM);
    ::pclose(m_server);
}

} // namespace cdr::viewer_test
