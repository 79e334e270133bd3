#pragma once

#include <cdr/depth/format.h>
#include <experiments/columns.h>

#include <functional>
#include <optional>
#include <string>

namespace cdr::experiments {

/// Whether a row is a rival's; rows of techniques leave it out.
/// @param isRival a member or a function of the row.
template <typename Row, typename Member>
Column<Row> rivalColumn(Member Row::*isRival) {
    return {.key = "rival",
            .value = [isRival](const Row& row) { return std::invoke(isRival, row) ? Json(true) : absent(); }};
}

/// The format of the depth buffer; null in JSON for a rival, which has none.
template <typename Row>
Column<Row> formatColumn(std::optional<depth::DepthFormat> Row::*format) {
    return {
        .key = "format",
        .value =
            [format](const Row& row) { return row.*format ? Json(nameOf(*(row.*format))) : Json(nullptr); },
        .heading = "format",
        .format = {.missing = "64-bit keys"}};
}

} // namespace cdr::experiments
