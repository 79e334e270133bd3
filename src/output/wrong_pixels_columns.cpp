#include "wrong_pixels_columns.h"

namespace cdr::output {

Columns<measure::WrongPixels> wrongPixelsColumns(const WrongPixelsHeadings& headings) {
    using Wrong = measure::WrongPixels;
    const CellFormat share{.pattern = "{} %", .scale = 100.0};
    return {{.key = "pixels", .value = &Wrong::pixels, .heading = headings.pixels},
            {.key = "wrong", .value = &Wrong::wrong, .heading = headings.wrong},
            {.key = "wrong_fraction", .value = &Wrong::fraction, .heading = headings.share, .format = share},
            {.key = "overlap_pixels", .value = &Wrong::overlapPixels},
            {.key = "overlap_wrong", .value = &Wrong::overlapWrong},
            {.key = "overlap_wrong_fraction",
             .value = &Wrong::overlapFraction,
             .heading = headings.overlapShare,
             .format = share},
            {.key = "edge_wrong", .value = &Wrong::edgeWrong}};
}

} // namespace cdr::output
