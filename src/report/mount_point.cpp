#include "mount_point.h"

#include <fstream>
#include <sstream>
#include <string>

namespace cdr::report {

namespace {

/// Spaces, tabs, line breaks and backslashes are three octal digits in the kernel's list.
std::string unescaped(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 3 < text.size()) {
            plain += static_cast<char>(std::stoi(text.substr(i + 1, 3), nullptr, 8));
            i += 3;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

} // namespace

bool isMountPoint(const std::filesystem::path& path) {
    std::ifstream mounts("/proc/self/mountinfo"); // proc(5): the fifth field is the mount point
    for (std::string line; std::getline(mounts, line);) {
        std::istringstream fields(line);
        std::string field;
        for (int i = 0; i < 5; ++i) {
            fields >> field;
        }
        if (unescaped(field) == path.string()) {
            return true;
        }
    }
    return false;
}

} // namespace cdr::report
