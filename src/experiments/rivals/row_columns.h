#pragma once

#include <cdr/depth/format.h>

#include <output/columns.h>

#include <functional>
#include <optional>

namespace cdr::experiments {

/// Whether a row is a rival's; rows of techniques leave it out.
/// @param isRival a member or a function of the row.
template <typename Row, typename Member>
output::Column<Row> rivalColumn(Member Row::*isRival) {
    return {.key = "rival", .value = [isRival](const Row& row) {
                return std::invoke(isRival, row) ? output::Json(true) : output::absent();
            }};
}

/// The format of the depth buffer; null in JSON for a rival, which has none.
template <typename Row>
output::Column<Row> formatColumn(std::optional<depth::DepthFormat> Row::*format) {
    return {.key = "format",
            .value =
                [format](const Row& row) {
                    return row.*format ? output::Json(nameOf(*(row.*format))) : output::Json(nullptr);
                },
            .heading = "format",
            .format = {.missing = "64-bit keys"}};
}

} // namespace cdr::experiments
