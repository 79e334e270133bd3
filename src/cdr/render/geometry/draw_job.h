#pragma once

#include <cdr/platform/worker_pool.h>

#include <cstddef>

namespace cdr::render {

/// A contiguous range of one cascade's draws.
struct DrawJob {
    std::size_t cascade = 0;
    platform::IndexRange draws; ///< into visibility::DrawLists::instance
};

} // namespace cdr::render
