#pragma once

#include <cdr/base/format_error.h>

#include <cmath>

namespace cdr::render {

/// base::InputError unless `length` is finite and not negative. @param what names it in the message
inline void requireLength(const char* what, double length) {
    if (!std::isfinite(length) || length < 0.0) {
        throw base::inputError("{} must be finite and not negative, not {}", what, length);
    }
}

} // namespace cdr::render
