#pragma once

#include <viewer/state/frame_statistics.h>

#include <string>

namespace cdr::viewer {

/// What draws, and how fast.
struct PerformanceModel {
    std::string device;   ///< that renders, with its driver
    std::string uiDevice; ///< that shows
    FrameStatistics statistics;
    double framesPerSecond = 0.0;
    double lagSeconds = 0.0;    ///< since the oldest picture was asked for that is not yet shown; 0 for none
    double uiFrameMs = 0.0;     ///< the interface, drawn and handed to the display
    double presentMs = 0.0;     ///< of it, waiting for and handing to the display
    bool rendersAlways = false; ///< though nothing changes: to see times settle
};

} // namespace cdr::viewer
