#include "sequence_name.h"

#include <cdr/base/format_error.h>

#include <fmt/format.h>

namespace cdr::cli {

SequenceName::SequenceName(const std::string& pattern) : m_before(pattern) {
    const std::size_t percent = pattern.find('%');
    if (percent == std::string::npos) {
        return;
    }
    std::size_t end = percent + 1;
    m_digits = 0;
    if (end + 1 < pattern.size() && pattern[end] == '0' && pattern[end + 1] >= '1' &&
        pattern[end + 1] <= '9') {
        m_digits = pattern[end + 1] - '0';
        end += 2;
    }
    if (end >= pattern.size() || pattern[end] != 'd' || pattern.find('%', end) != std::string::npos) {
        throw base::inputError("{}: a frame number is written as one %d or %04d", pattern.substr(0, 200));
    }
    m_before = pattern.substr(0, percent);
    m_after = pattern.substr(end + 1);
}

std::filesystem::path SequenceName::at(unsigned frame) const {
    return hasNumber() ? fmt::format("{}{:0{}}{}", m_before, frame, m_digits, m_after) : m_before;
}

} // namespace cdr::cli
