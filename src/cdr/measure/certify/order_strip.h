#pragma once

#include <cdr/measure/certify/device_bound.h>
#include <cdr/measure/certify/drawn_frame.h>
#include <cdr/measure/certify/screen_triangle.h>
#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/screen_bounds.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cdr::measure {

/// What geometry and the device's bound say of a drawn pixel.
enum class PixelVerdict : std::uint8_t {
    certified, ///< the drawn object is there, nearest by more than the device may be off, and so is no edge near
    proven,    ///< a device may draw something else, but triangles placed in float64 show that this is right
    open,      ///< a device may draw this or something else
    refused    ///< no device that keeps to its limits draws this
};

/// A verdict, and what else is known of the pixel.
struct PixelFinding {
    PixelVerdict verdict = PixelVerdict::open;
    bool isMasked = false;  ///< a masked surface may be there, no farther than the drawn object surely is
    bool isBlended = false; ///< the same of a blended one
    /// How far off a device may have drawn the distance, on that surface of the drawn object where it is least.
    float offView = 0.0f;
};

/// What a triangle that goes into a strip is part of.
struct StripSurface {
    std::uint32_t id = 0; ///< object index + 1
    /// What is blended hides nothing.
    scene::AlphaMode alphaMode = scene::AlphaMode::opaque;
    LayerOffset layer{};
    /// What float64 rays meet of a masked one, else null.
    const MaskedPixels* masked = nullptr;
};

/// Some rows of a drawn picture. All triangles that may be seen there go in, in any order; verdicts come out.
///
/// Each triangle gives a pixel an interval of view distances: where its surface is, and by how much the device may be off.
/// It surely covers the pixel if the centre is inside it, and farther from its edges than corners may be off. It may cover
/// the pixel if the centre is outside by no more than that. Where a surface goes on beyond an edge, inside is enough.
/// A layer's offset is taken off these, so surfaces are compared in the order of distance less layer.
/// Devices filter textures in ways that no bound is known of, so there a masked surface covers no pixel surely. Float64 rays read
/// a texture in one way, which says what the mask keeps.
/// The drawn distance says which triangles cannot matter, so most of what is hidden is never looked at.
class OrderStrip {
  public:
    /// @param pixels whole rows of the frame.
    /// @param farthestLayer the most that a layer of the scene moves a surface away from the camera, 0 or more, scene units.
    OrderStrip(const DrawnFrame& frame, const DeviceBound& bound, const PixelRect& pixels,
               double farthestLayer);

    /// Some pixels alone of another strip, as float64 rays see them.
    /// @param open that the other strip leaves open.
    /// @param bound of float64.
    OrderStrip(const OrderStrip& device, std::span<const glm::uvec2> open, const DeviceBound& bound);

    /// Whether all whose distance less its layer is `leastView` or more is behind what was drawn in a rectangle of the picture.
    bool hides(const PixelRect& pixels, double leastView) const;
    void enter(const ScreenTriangle& triangle, const StripSurface& surface);
    /// Has refused pixels examine all that is farther too, since what was drawn may be farther than its distance says.
    /// @return whether any was refused, so that all triangles have to go in once more
    bool lookFarther();
    PixelFinding findingAt(std::uint32_t x, std::uint32_t y) const;

  private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();
    static constexpr std::uint32_t kTile = 8;

    /// Where a surface may be at a pixel.
    struct Interval {
        double least;
        double most;
    };
    /// Bounds of view distances less layers at a pixel.
    struct Order {
        double least = kNever;       ///< of the drawn object, if it is there
        double most = kNever;        ///< least of what its sure surfaces may be at
        double nearest = kNever;     ///< where its nearest sure surface is
        double mostBeside = 0.0;     ///< of its surfaces beyond edges nearby; infinity where it may end there
        double otherLeast = kNever;  ///< of other objects that may be there
        double maskedLeast = kNever; ///< of masked surfaces that may be there
        double blendedLeast = kNever; ///< of blended ones
        double otherMost = kNever;    ///< of the nearest other one that has the pixel within a triangle
        double offView = kNever;      ///< PixelFinding::offView
        bool isAtDrawn = false;       ///< the nearest sure surface is at the drawn distance
    };
    /// Of pixels in a row, none where first > last.
    struct Span {
        double first;
        double last;
    };
    /// Twice the area of an edge and a point, at (x, y) of the picture, positive inside.
    struct Edge {
        double perX;
        double perY;
        double atOrigin;
        double margin; ///< by how much that may be off
        double at(double x, double y) const { return perX * x + perY * y + atOrigin; }
        /// Cuts the part of a row off where the edge is below `least`.
        void cut(Span& span, double y, double least) const;
    };
    /// How a triangle covers a pixel.
    enum class Cover : std::uint8_t {
        within, ///< far from its edges
        surely, ///< inside, but near an edge beyond which the surface goes on
        goesOn, ///< outside, and near such an edge
        perhaps ///< near an edge where the surface may end
    };

    void keepReach(std::uint32_t x, std::uint32_t y, double reach);
    static PixelVerdict verdictOnBackground(const Order& order);
    static PixelVerdict verdictOnObject(const Order& order, double reach);
    std::array<Edge, 3> edgesOf(const ScreenTriangle& triangle) const;
    /// The triangle's box with what its corners may be off.
    PixelRect boxOf(const ScreenTriangle& triangle) const;
    void enterRow(const ScreenTriangle& triangle, const StripSurface& surface,
                  const std::array<Edge, 3>& edges, const PixelRect& box, std::uint32_t row);
    void enterThin(const ScreenTriangle& triangle, const StripSurface& surface, const PixelRect& box);
    Cover coverAt(const ScreenTriangle& triangle, const std::array<Edge, 3>& edges, double x, double y) const;
    void enterPixel(const ScreenTriangle& triangle, const StripSurface& surface, std::uint32_t x,
                    std::uint32_t y, Cover cover);
    Interval intervalAt(const StripSurface& surface, double distanceView, double slopeView,
                        double offView) const;
    void enterPerhaps(const StripSurface& surface, std::uint32_t x, std::uint32_t y, double least,
                      double offView);

    std::size_t indexOf(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y - m_pixels.top} * m_frame.ids.width + x;
    }

    const DrawnFrame& m_frame;
    const DeviceBound& m_bound;
    bool m_readsMasks; ///< else a device may cut away any pixel of a masked surface
    PixelRect m_pixels;
    std::vector<double> m_reach; ///< per pixel: what is farther is behind what was drawn
    std::uint32_t m_tileColumns;
    std::vector<double> m_tileReach; ///< the farthest of a tile's
    std::vector<Order> m_orders;
};

} // namespace cdr::measure
