#pragma once

#include <cdr/measure/compare/wrong_pixels.h>

#include <output/columns.h>

#include <string>

namespace cdr::output {

/// What tables call the counts; they leave out those without a name.
struct WrongPixelsHeadings {
    std::string pixels{};
    std::string wrong{};
    std::string share{};
    std::string overlapShare{};
};

/// The fields that say how a picture compares with the truth. They are named alike wherever one is counted:
/// "pixels" (inner ones), "wrong", "wrong_fraction", "overlap_pixels", "overlap_wrong",
/// "overlap_wrong_fraction" and "edge_wrong". A fraction of no pixels is null, and an empty cell.
Columns<measure::WrongPixels> wrongPixelsColumns(const WrongPixelsHeadings& headings = {});

} // namespace cdr::output
