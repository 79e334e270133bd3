#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/measure/certify/drawn_frame.h>
#include <cdr/measure/certify/layer_offset.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cdr::measure {

/// Eight times what an operation of float64 rounds by, since what a certificate computes goes through a few more than a shader.
inline constexpr double kDoubleOperation = 0x1p-50;

/// How large the numbers are that a device rounds while it draws a triangle.
struct TriangleReach {
    double leastView = 0.0; ///< view distance of the nearest corner, after clipping
    double mostView = 0.0;  ///< of the farthest
    double acrossView =
        0.0; ///< most that a sum of products to a corner's view-space x or y holds, in magnitude
    double alongView = 0.0; ///< the same of what is added to the object's own distance
    /// Most that the terms hold, in magnitude, which float64 sums up to one coordinate of a corner. They may cancel, as where an
    /// object's middle is far to the side.
    double summedView = 0.0;
    LayerOffset layer{}; ///< of the surface
};

/// What may go wrong with a triangle.
struct TriangleBound {
    double pixels = 0.0;       ///< how far a corner may be off, along x and along y
    double distanceView = 0.0; ///< how far a corner's view distance may be off
    double depth = 0.0;        ///< how far a depth may be off before it is stored
    double bend = 0.0;         ///< by which share of the distance interpolated logarithms are off
};

/// What may go wrong with a frame: the largest of each part over the triangles and pixels that were examined.
struct FrameBound {
    double pixels = 0.0;       ///< TriangleBound::pixels; half a sub-pixel is a part of it
    double distanceView = 0.0; ///< TriangleBound::distanceView, scene units
    double depth = 0.0;        ///< TriangleBound::depth, depth of 0 to 1
    double stepView = 0.0;     ///< step of the depth buffer at a drawn distance, scene units

    /// Takes a triangle's bound in.
    void add(const TriangleBound& bound);
    /// Takes that of another part of the frame in.
    void add(const FrameBound& other);
};

/// How far off a device may draw, from its stated sub-pixel bits and from float32's arithmetic. With u = 2^-24:
///
/// - A corner's x has at most 4 roundings of a sum of products, 2 of a projection and 2 of w, itself a sum. A division adds
///   one, and a viewport 2. A lens shift has 2, of its product and of the difference. Half a sub-pixel is added to these.
///   Before the anchor plane, w has what the distance to that plane rounds, which may be more than w.
/// - A distance has 2 roundings of its own and at most 4 of its sum of products. That is 8 u of the largest
///   number in it.
/// - A depth has 3 roundings as depth::DepthRounding counts them. Drivers form it from a plane over the picture, by a
///   product and a sum along each axis. That is 8 u of the largest depth of the triangle. What that plane's slope adds is a
///   shift of pixels.
/// - A buffer adds its step, and a slanted surface what it rises over the pixels that its corners are off.
///
/// - A layer offset has as many roundings again, in the depth that it adds. A device moves the surface by more than the offset:
///   by two steps of the buffer and what rounded vertices part, once for each rank of the layer.
///
/// A triangle's corners and plane are formed in float64. What that rounds is added, whatever the device: of corners by the terms
/// of their sums, which may be far larger than their distance, and of a plane most for slivers.
///
/// Roundings count at their worst and in one direction. No specification bounds how a driver interpolates, so this is
/// tested and not proven. No certified pixel rests on it, but for how far off its distance may be, see Certifier.
class DeviceBound {
  public:
    explicit DeviceBound(const DrawnFrame& frame);

    /// The bound of a device that would compute in float64, snap no vertex and store depth without rounding. It is the error
    /// of triangles that are placed in float64.
    static DeviceBound ofFloat64(const DrawnFrame& frame);

    TriangleBound of(const TriangleReach& reach) const;

    /// How far the depth of a surface may be off, as a view distance, its step in the buffer included. Infinity where the
    /// buffer resolves nothing.
    /// @param slopeView by how much the distance changes along x and along y, added up, per pixel.
    double orderView(const TriangleBound& bound, double distanceView, double slopeView,
                     const LayerOffset& layer = {}) const {
        const Cell& cell = cellAt(distanceView - layer.movedView(distanceView));
        return cell.stepView + bound.depth * cell.viewPerDepth + bound.bend * distanceView +
               surfaceView(bound, distanceView, slopeView);
    }

    /// By how much more than its layer's offset a surface may be moved, to the same side.
    double partingView(const LayerOffset& layer, double distanceView, double slopeView) const {
        // The slope is taken from neighbouring pixels, and the step where the surface is before it is moved or after.
        const double stepView = std::max(cellAt(distanceView).stepView,
                                         cellAt(distanceView - layer.movedView(distanceView)).stepView);
        return 2.0 * layer.ranks * (2.0 * stepView + 2.0 * m_snapPixels * slopeView);
    }

    /// How far the distance that is kept of a surface may be off.
    static double surfaceView(const TriangleBound& bound, double distanceView, double slopeView) {
        return bound.distanceView + slopeView * bound.pixels + kDoubleRounding * distanceView;
    }

    /// DrawnFrame::snapPixels.
    double snapPixels() const { return m_snapPixels; }

    /// The step of the buffer around a distance.
    double stepView(double distanceView) const { return cellAt(distanceView).stepView; }

  private:
    /// What bounds hold between two distances, an eighth of an octave apart or less.
    struct Cell {
        double stepView = 0.0;
        double viewPerDepth = 0.0;
    };
    struct Range {
        depth::Cascade clip;
        depth::DepthRange range;
        double anchorView;
    };
    static constexpr double kDoubleRounding = 0x1p-46;

    DeviceBound(const DrawnFrame& frame, double rounding, double snapPixels);

    /// What the anchor adds, which a corner's w is counted from: 4 roundings of the distance to it, its own, and their sum. Where
    /// that is half of w and more, a corner may be anywhere.
    double anchorPixels(const TriangleReach& reach, double beforeAnchor) const;
    const Cell& cellAt(double distanceView) const;
    Cell makeCell(double leastView, double mostView, depth::DepthFormat format) const;

    std::vector<Range> m_ranges; ///< of cascades; empty where distances are kept as they are
    std::uint64_t m_firstCell = 0;
    std::vector<Cell> m_cells{Cell{}};
    double m_rounding; ///< of one operation, relative
    double m_snapPixels;
    double m_pixelsPerSlope;
    double m_picturePixels; ///< width and height
    double m_shiftPixels;   ///< of the lens
    bool m_bends = false;
};

} // namespace cdr::measure
