#pragma once

#include <viewer/state/view_settings.h>

#include <cstdint>
#include <optional>
#include <random>

namespace cdr::viewer {

/// What a soak does in one frame.
struct SoakStep {
    CameraInput input;
    bool orbits = false;                  ///< input is for orbit(), not fly()
    bool zooms = false;                   ///< scroll is for the lens, not for the orbit's distance
    std::optional<glm::uvec2> click;      ///< pixel to pick
    std::optional<PictureExtent> resize;  ///< 1x1 to the largest
    std::optional<ViewSettings> settings; ///< all of them, from now on
    bool minimises = false;               ///< the window goes away for the next few frames
    bool screenshot = false;
    bool returnsHome = false; ///< the scene's own camera, before it is lost in space
};

/// Largest picture that a soak asks for by default: software renderers must keep up.
inline constexpr PictureExtent kSoakLargest{1920, 1080};

/// What a soak may choose from.
struct SoakOptions {
    std::uint64_t seed = 2013;
    std::vector<std::string> scenes{"cubes", "afc", "rotation", "mixed"};
    std::size_t mostThreads = 4;
    PictureExtent largest = kSoakLargest; ///< of the windows, at least 1x1
};

/// Random input, the same for the same options on every platform. Keys are held for a while, the mouse drags
/// and jumps, the wheel turns. Sizes of windows, techniques, views, targets, threads and effects change.
/// Bounded in every value; each step follows from those before.
class SoakInput {
  public:
    explicit SoakInput(SoakOptions options = {});

    SoakStep next();

  private:
    double uniform(double low, double high);
    std::size_t pick(std::size_t count); ///< below count
    bool chance(double share) { return uniform(0.0, 1.0) < share; }
    void moveMouse(CameraInput& input);
    void changeSettings();
    void changeFinish();

    SoakOptions m_options;
    std::mt19937_64 m_random;
    CameraKeys m_keys;
    PictureExtent m_extent;
    ViewSettings m_settings;
    bool m_drags = false;
    bool m_pans = false;
    bool m_orbits = false;
    glm::dvec2 m_cursor{0.0};
};

} // namespace cdr::viewer
