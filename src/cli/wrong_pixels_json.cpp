#include "wrong_pixels_json.h"

#include <nlohmann/json.hpp>

namespace cdr::cli {

void addWrongPixels(nlohmann::ordered_json& row, const measure::WrongPixels& wrong) {
    row["pixels"] = wrong.pixels;
    row["wrong"] = wrong.wrong;
    row["wrong_fraction"] = wrong.fraction();
    row["overlap_pixels"] = wrong.overlapPixels;
    row["overlap_wrong"] = wrong.overlapWrong;
    row["overlap_wrong_fraction"] = wrong.overlapFraction();
    row["edge_wrong"] = wrong.edgeWrong;
}

} // namespace cdr::cli
