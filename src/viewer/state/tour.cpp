#include "tour.h"

#include <algorithm>

namespace cdr::viewer {

std::uint32_t tourFrame(double seconds, std::uint32_t frames) {
    const double share = std::clamp(seconds / kTourSeconds, 0.0, 1.0);
    return static_cast<std::uint32_t>(share * (frames - 1));
}

std::string_view tourCaption(double fovDegrees) {
    if (fovDegrees > 20.0) {
        return "A window of a space station, 420 km above the Earth. Left standard depth, right anchored.";
    }
    if (fovDegrees > 1.0) {
        return "The lens narrows. Frame, station and ground share one camera and one range of depth.";
    }
    if (fovDegrees > 0.1) {
        return "An airport. Standard depth stores one number for surfaces centimetres apart.";
    }
    if (fovDegrees > 0.005) {
        return "The runway. Its paint lies 5 mm over the slab: a hundred-millionth of the distance.";
    }
    return "The runway's number. Where the left side breaks up, soil shows through slab and paint: z-fighting.";
}

} // namespace cdr::viewer
