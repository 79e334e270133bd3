#pragma once

#include <cdr/platform/file.h>

namespace cdr::runs {

/// Whether bytes are one value of CBOR (RFC 8949) that output::Json reads without going deep into calls: of known lengths,
/// without tags, and nested no deeper than any result is.
bool isShallowCbor(const platform::Bytes& bytes);

} // namespace cdr::runs
