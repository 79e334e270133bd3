#pragma once

#include <experiments/columns.h>

#include <string>

namespace cdr::experiments {

/// Whether a row is a rival's; rows of techniques leave it out.
template <typename Row>
Column<Row> rivalColumn(bool Row::*isRival) {
    return {.key = "rival",
            .value = [isRival](const Row& row) { return row.*isRival ? Json(true) : absent(); }};
}

/// The format of the depth buffer; null in JSON where it is empty, since a rival has none.
template <typename Row>
Column<Row> formatColumn(std::string Row::*format) {
    return {
        .key = "format",
        .value =
            [format](const Row& row) { return (row.*format).empty() ? Json(nullptr) : Json(row.*format); },
        .heading = "format",
        .format = {.missing = "64-bit keys"}};
}

} // namespace cdr::experiments
