#include "whole_file.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace cdr::output {

namespace {

namespace fs = std::filesystem;

std::string lastBytes(std::ifstream& file, std::uint64_t size, std::uint64_t count) {
    std::string bytes(std::min(size, count), '\0');
    file.seekg(static_cast<std::streamoff>(size - bytes.size()));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

bool isWholePng(std::ifstream& file, std::uint64_t size) {
    constexpr std::string_view kLastChunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);
    return lastBytes(file, size, kLastChunk.size()) == kLastChunk;
}

bool isWholeSvg(std::ifstream& file, std::uint64_t size) {
    constexpr std::uint64_t kTail = 64; // the closing tag and space after it
    return lastBytes(file, size, kTail).find("</svg>") != std::string::npos;
}

std::uint64_t bigEndian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (const char byte : bytes) {
        value = value << 8u | static_cast<std::uint8_t>(byte);
    }
    return value;
}

/// Whether the boxes (ISO/IEC 14496-12, 4.2) fill the file and the index of the video, "moov", is among them.
bool isWholeMp4(std::ifstream& file, std::uint64_t size) {
    bool hasIndex = false;
    std::uint64_t at = 0;
    while (at < size) {
        std::string head(16, '\0');
        file.seekg(static_cast<std::streamoff>(at));
        file.read(head.data(), static_cast<std::streamsize>(head.size()));
        file.clear(); // the last box may be shorter
        hasIndex |= head.substr(4, 4) == "moov";
        std::uint64_t length = bigEndian(head.substr(0, 4));
        if (length == 1) {
            length = bigEndian(head.substr(8));
        }
        if (length < 8 || length > size - at) {
            return false;
        }
        at += length;
    }
    return hasIndex;
}

bool isWhole(const fs::path& path) {
    std::error_code error;
    const std::uint64_t size = fs::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file) {
        return false;
    }
    const std::string extension = platform::lowerExtension(path);
    if (extension == ".png") {
        return isWholePng(file, size);
    }
    return extension == ".svg" ? isWholeSvg(file, size) : isWholeMp4(file, size);
}

} // namespace

void requireWhole(const fs::path& written, const fs::path& name, const std::string& program) {
    if (!isWhole(written)) {
        throw base::runError("{}: {} did not write all of it; the disk may be full", name.string(), program);
    }
}

} // namespace cdr::output
