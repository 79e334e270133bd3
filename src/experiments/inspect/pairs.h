#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace cdr::experiments {

/// Two objects that pixels show in front of each other, over all views. Only pixels whose eight neighbours show the same
/// two count: elsewhere outlines and lines where surfaces cross decide. If no pixel of a coplanar pair is such, all of its pixels
/// count: stripes may be that narrow.
struct ObjectPair {
    std::uint32_t front = 0; ///< object index of what is seen
    std::uint32_t back =
        0; ///< of what lies next behind it; the lower index is in front where they are coplanar
    std::uint64_t pixels = 0; ///< that show the pair in this order
    std::uint64_t coplanar =
        0; ///< that show both at one distance, to within the rounding of their own vertices
    double gapView =
        std::numeric_limits<double>::infinity(); ///< the smallest over the distance, along the view
    double atView = 0.0;                         ///< where that is
    double widestGapView = 0.0;                  ///< over all pixels of the pair
    /// The object behind is thin, lies close behind the other in most pixels, and no view shows it: a decal that sank.
    bool isSunk = false;

    /// No depth buffer separates faces that lie in one plane.
    bool isCoplanar() const { return coplanar > 0; }
};

/// Collects the pairs of many views of a scene.
class PairCollector {
  public:
    /// @param scene must outlive the collector.
    explicit PairCollector(const scene::Scene& scene);

    /// @param blended of the same view, by blendedInPlane().
    void add(const scene::Camera& camera, const measure::TruthImage& truth, const image::ImageU32& blended);

    /// Those that are nearest to each other first, for their distance: coplanar ones by their pixels, then the others by
    /// gap over distance.
    std::vector<ObjectPair> pairs() const;

    /// Per pixel: 1 where the two nearest surfaces lie in one plane, so that neither is wrong.
    image::Raster<std::uint8_t> coplanarMask(const scene::Camera& camera,
                                             const measure::TruthImage& truth) const;

    /// Per pixel: the blended object (index + 1) that lies in one plane with the opaque surface of another one, 0 where none
    /// does. No depth buffer says whether it is laid over that surface. Object ids are of opaque surfaces, so none is wrong.
    /// @param shapes of the scene's meshes.
    image::ImageU32 blendedInPlane(const scene::Camera& camera, const measure::TruthImage& truth,
                                   std::span<const measure::Shape> shapes,
                                   platform::WorkerPool& workers) const;

    /// By how much surfaces of two objects may differ at a pixel that lie in one plane.
    /// @param ray of the pixel, one unit along the view
    double roundingViewAt(std::uint32_t first, std::uint32_t second, double distanceView,
                          const glm::dvec3& ray, const scene::Camera& camera) const;

  private:
    /// @param extents the sum of both. @param distanceView of the nearer surface.
    static double roundingView(double extents, double distanceView);
    bool areInPlane(std::uint32_t first, std::uint32_t second, double gapView, double distanceView,
                    const glm::dvec3& ray, const scene::Camera& camera) const;
    void addBlended(const measure::TruthImage& truth, const image::ImageU32& blended);
    double extentAt(std::uint32_t object, const glm::dvec3& place) const;
    bool isThin(std::uint32_t object) const;

    const scene::Scene& m_scene;
    std::vector<std::vector<std::uint32_t>> m_instances; ///< per object
    std::vector<double> m_extents; ///< per object: how far any of its vertices reaches from its origin
    std::vector<bool> m_isSeen;    ///< per object
    struct Found {
        ObjectPair pair;
        std::uint64_t close = 0; ///< pixels whose gap is small for the object behind
    };
    using Pairs = std::map<std::pair<std::uint32_t, std::uint32_t>, Found>;
    Pairs m_pairs;  ///< by front and back; coplanar by lower index
    Pairs m_narrow; ///< the same of coplanar pixels whose neighbours show others
};

} // namespace cdr::experiments
