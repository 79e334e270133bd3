#pragma once

#include "models.h"

#include <cdr/image/image.h>

#include <string>
#include <vector>

namespace cdr::experiments {

/// A row for each model: base colour alone, the picture, the reference, and FLIP between the two. All pictures are of one size.
image::ImageRgba8 makeModelSheet(const std::vector<ModelResult>& results, const std::string& title);

} // namespace cdr::experiments
