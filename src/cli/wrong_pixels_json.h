#pragma once

#include <cdr/measure/compare/wrong_pixels.h>

#include <nlohmann/json_fwd.hpp>

namespace cdr::cli {

/// Adds the fields that say how a picture compares with the truth, named alike wherever one is counted:
/// "pixels" (inner ones), "wrong", "wrong_fraction", "overlap_pixels", "overlap_wrong",
/// "overlap_wrong_fraction" and "edge_wrong".
void addWrongPixels(nlohmann::ordered_json& row, const measure::WrongPixels& wrong);

} // namespace cdr::cli
