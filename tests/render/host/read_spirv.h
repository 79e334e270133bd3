#pragma once

#include <cdr/gpu/pipeline.h>

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

/// A shader that the build compiled. Throws where the file is missing.
inline gpu::Spirv readSpirv(const char* path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) {
        throw std::runtime_error(std::string(path) + " cannot be read");
    }
    std::vector<std::uint32_t> words(static_cast<std::size_t>(file.tellg()) / sizeof(std::uint32_t));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(words.data()),
              static_cast<std::streamsize>(words.size() * sizeof(std::uint32_t)));
    return gpu::Spirv(std::move(words));
}

} // namespace cdr::render_test
