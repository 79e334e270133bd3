#pragma once

#include <cstdint>
#include <string>

namespace cdr::image {

/// base::InputError, naming the limit, unless a picture of this size may be decoded.
void requireDecodableSize(std::uint64_t width, std::uint64_t height, const std::string& name);

} // namespace cdr::image
