#pragma once

#include <glm/glm.hpp>

#include <bitset>
#include <cstdint>
#include <initializer_list>

namespace cdr::viewer {

/// What a held key asks of the camera.
enum class CameraKey : std::uint8_t { forward, backward, left, right, up, down, faster, slower };
inline constexpr std::size_t kCameraKeys = 8;

/// The keys that are held.
class CameraKeys {
  public:
    CameraKeys() = default;
    CameraKeys(std::initializer_list<CameraKey> held) {
        for (const CameraKey key : held) {
            set(key, true);
        }
    }

    bool has(CameraKey key) const { return m_held.test(static_cast<std::size_t>(key)); }
    void set(CameraKey key, bool held) { m_held.set(static_cast<std::size_t>(key), held); }
    bool none() const { return m_held.none(); }
    bool operator==(const CameraKeys&) const = default;

  private:
    std::bitset<kCameraKeys> m_held;
};

/// What a gamepad asks of the camera, each from -1 to 1, 0 where there is none (gamepadAxes()).
struct CameraAxes {
    glm::dvec3 move{0.0}; ///< right, up, forward
    glm::dvec2 look{0.0}; ///< right, up
    double zoom = 0.0;    ///< in

    bool operator==(const CameraAxes&) const = default;
};

/// The picture that pixels of input belong to.
struct PictureExtent {
    std::uint32_t width = 1280; ///< pixels, at least 1
    std::uint32_t height = 720;

    double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
    bool operator==(const PictureExtent&) const = default;
};

/// A cursor that is outside every picture.
inline constexpr glm::dvec2 kNoCursor{-1.0};

/// Seconds of input that one frame may apply, so that a frame that took long does not throw the camera far away.
inline constexpr double kLongestStep = 0.25;

/// What a person asked of the camera during one frame. Nothing in it is of a window system.
struct CameraInput {
    CameraKeys keys{};
    glm::dvec2 drag{0.0}; ///< movement with the button that looks or turns held: pixels, x right, y down
    glm::dvec2 look{0.0}; ///< with the button that looks about though the camera orbits
    glm::dvec2 turn{0.0}; ///< with the button that goes round the pivot though the camera flies
    glm::dvec2 pan{0.0};  ///< movement with the button that shifts held: pixels, x right, y down
    glm::dvec2 cursor{kNoCursor}; ///< pixels from the picture's top left corner
    double scroll = 0.0;          ///< notches that go nearer, away from the person positive
    double lens = 0.0;            ///< notches that narrow the lens
    bool flies = false;           ///< keys fly though the camera orbits
    CameraAxes axes{};
    double seconds = 0.0; ///< since the last frame, >= 0
    PictureExtent extent{};
};

} // namespace cdr::viewer
