#pragma once

#include <cdr/depth/technique.h>

#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Table 4.1 and Figure 4.1: the smallest resolvable separation over view distance, by formula.
struct PrecisionOptions {
    double nearView = 0.001;
    double farView = 1e8;
    double spanView = 32.0; ///< depth of what a fitted cascade encloses: the afc field's
    std::vector<double> separations{0.001, 0.01, 0.1, 1.0};
};

/// One cell of the table.
struct PrecisionCell {
    std::string technique;
    std::string format;
    double separation = 0.0;
    /// View distance at which the separation is first reached; infinity when never.
    double reachedFirstView = 0.0;
    /// Last view distance at which the technique still resolves less than it.
    double heldLastView = 0.0;
    /// The thesis' value, where its Table 4.1 has the cell.
    std::optional<double> thesisView;
};

/// One point of the figure.
struct PrecisionPoint {
    double distanceView = 0.0;
    std::vector<double> separations; ///< by technique, as in PrecisionResult::curveNames
};

struct PrecisionResult {
    std::vector<PrecisionCell> table; ///< by the thesis' own arithmetic, 24 bits
    std::vector<PrecisionCell>
        byFormat; ///< every technique and depth format, by the exact arithmetic of cdr::depth
    std::vector<std::string> curveNames;
    std::vector<PrecisionPoint> curve;
};

/// base::InputError for an unusable range.
PrecisionResult runPrecision(const PrecisionOptions& options);

} // namespace cdr::experiments
