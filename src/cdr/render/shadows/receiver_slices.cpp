#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/scene/box_tree.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace cdr::render {

namespace {

scene::Box boxAround(std::span<const SeenSphere> spheres) {
    scene::Box box;
    for (const SeenSphere& sphere : spheres) {
        box.add(sphere.centre, sphere.radius);
    }
    return box;
}

std::array<glm::dvec3, 8> cornersOf(const scene::Camera& camera, const scene::Frustum& frustum,
                                    double nearView, double farView) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const double w = (i & 4) != 0 ? farView : nearView;
        const double x = (((i & 1) != 0 ? 1.0 : -1.0) * frustum.tanX + frustum.centre.x) * w;
        const double y = (((i & 2) != 0 ? 1.0 : -1.0) * frustum.tanY + frustum.centre.y) * w;
        corners[static_cast<std::size_t>(i)] = camera.right * x + camera.up * y - camera.back * w;
    }
    return corners;
}

/// Where the surfaces of a slice are: both in its part of the frustum and in the box around its spheres. Each of the two is
/// taken as a box along the camera's axes.
void placeReceivers(const scene::Camera& camera, ReceiverSlice& slice) {
    scene::Box view;
    scene::Box boxes;
    const auto along = [&](const glm::dvec3& corner) {
        return glm::dvec3(glm::dot(camera.right, corner), glm::dot(camera.up, corner),
                          glm::dot(camera.back, corner));
    };
    for (std::size_t i = 0; i < slice.view.size(); ++i) {
        view.add(along(slice.view[i]));
        boxes.add(along(slice.boxes[i]));
    }
    const glm::dvec3 low = glm::max(view.low, boxes.low);
    const glm::dvec3 high = glm::max(glm::min(view.high, boxes.high), low);
    const glm::dvec3 middle = 0.5 * (low + high);
    slice.middle = camera.right * middle.x + camera.up * middle.y + camera.back * middle.z;
    slice.reach = 0.5 * glm::distance(low, high);
    const glm::dvec2 nearest(1.0 / std::max(-high.z, slice.nearView));
    const glm::dvec2 farthest(1.0 / std::max(-low.z, slice.nearView));
    slice.lowRay = glm::min(glm::dvec2(low) * nearest, glm::dvec2(low) * farthest);
    slice.highRay = glm::max(glm::dvec2(high) * nearest, glm::dvec2(high) * farthest);
}

/// The slices between neighbouring ends in which something is seen.
std::vector<ReceiverSlice> cutAt(const std::vector<double>& ends, const scene::Camera& camera,
                                 const scene::Frustum& frustum, std::span<const SeenSphere> seen) {
    std::vector<std::vector<SeenSphere>> spheres(ends.size() - 1);
    for (const SeenSphere& sphere : seen) {
        // From the slice that holds the sphere's near end to the one that holds its far end.
        const auto begin =
            std::upper_bound(ends.begin() + 1, ends.end(), sphere.distanceView - sphere.radius);
        for (auto end = begin; end != ends.end(); ++end) {
            spheres[static_cast<std::size_t>(end - ends.begin()) - 1].push_back(sphere);
            if (*end > sphere.distanceView + sphere.radius) {
                break;
            }
        }
    }
    std::vector<ReceiverSlice> slices;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (!spheres[i].empty()) {
            ReceiverSlice& slice = slices.emplace_back();
            slice.nearView = ends[i];
            slice.farView = ends[i + 1];
            slice.view = cornersOf(camera, frustum, std::max(ends[i], camera.nearView),
                                   std::min(ends[i + 1], camera.farView));
            slice.seen = std::move(spheres[i]);
            slice.boxes = boxAround(slice.seen).corners();
            placeReceivers(camera, slice);
        }
    }
    return slices;
}

/// A part of the frustum, as spheres side by side that are hardly deeper than it. Wide lenses get wider ones.
void addSection(std::vector<SeenSphere>& seen, const scene::Camera& camera, const scene::Frustum& frustum,
                const depth::Interval& section) {
    constexpr double kMostAlong = 16.0;
    const double middleView = 0.5 * (section.nearView + section.farView);
    const double least = std::max(0.5 * (section.farView - section.nearView), 0.25 * section.farView);
    const glm::dvec2 half = glm::dvec2(frustum.tanX, frustum.tanY) * section.farView;
    const glm::dvec2 along = glm::clamp(glm::ceil(half / least), 1.0, kMostAlong);
    const glm::dvec2 tile = half / along;
    // A shifted lens moves the frustum's far end sideways by another length than its near end.
    const glm::dvec2 skew = glm::abs(frustum.centre) * 0.5 * (section.farView - section.nearView);
    const double radius = glm::length(glm::dvec3(tile + skew, 0.5 * (section.farView - section.nearView)));
    for (double y = 0.5; y < along.y; ++y) {
        for (double x = 0.5; x < along.x; ++x) {
            const glm::dvec2 place = frustum.centre * middleView + (2.0 * glm::dvec2(x, y) - along) * tile;
            seen.push_back({camera.right * place.x + camera.up * place.y - camera.back * middleView, radius,
                            middleView});
        }
    }
}

/// Today's practice, for comparison.
std::vector<ReceiverSlice> practicalSlices(const scene::Camera& camera, const scene::Frustum& frustum,
                                           std::span<const SeenSphere> seen) {
    double nearView = camera.farView;
    double farView = camera.nearView;
    for (const SeenSphere& sphere : seen) {
        nearView = std::min(nearView, std::max(sphere.distanceView - sphere.radius, camera.nearView));
        farView = std::max(farView, std::min(sphere.distanceView + sphere.radius, camera.farView));
    }
    if (!(nearView < farView)) {
        return {};
    }
    constexpr int kPracticalSlices = 4;
    constexpr double kShareOfLogarithm = 0.5;
    std::vector<double> ends;
    for (int i = 0; i <= kPracticalSlices; ++i) {
        const double share = static_cast<double>(i) / kPracticalSlices;
        ends.push_back(glm::mix(glm::mix(nearView, farView, share),
                                nearView * std::pow(farView / nearView, share), kShareOfLogarithm));
    }
    ends.back() = std::nextafter(static_cast<float>(farView), std::numeric_limits<float>::infinity());
    std::vector<ReceiverSlice> slices = cutAt(ends, camera, frustum, seen);
    for (ReceiverSlice& slice : slices) {
        slice.boxes = slice.view;
        placeReceivers(camera, slice);
    }
    return slices;
}

} // namespace

void addOccupied(std::vector<SeenSphere>& seen, const scene::Camera& camera, const scene::Frustum& frustum,
                 std::span<const depth::Interval> occupied) {
    std::map<int, depth::Interval> sections; // by exponent, so there are few however many intervals there are
    for (const depth::Interval& interval : occupied) {
        const double nearView = std::max(interval.nearView, camera.nearView);
        const double farView = std::min(interval.farView, camera.farView);
        if (!(nearView <= farView)) {
            continue;
        }
        for (int exponent = std::ilogb(nearView); exponent <= std::ilogb(farView); ++exponent) {
            const depth::Interval here{std::max(nearView, std::exp2(exponent)),
                                       std::min(farView, std::exp2(exponent + 1))};
            const auto [section, isFirst] = sections.try_emplace(exponent, here);
            if (!isFirst) {
                section->second = {std::min(section->second.nearView, here.nearView),
                                   std::max(section->second.farView, here.farView)};
            }
        }
    }
    for (const auto& [exponent, section] : sections) {
        addSection(seen, camera, frustum, section);
    }
}

std::vector<SeenSphere> seenSpheres(const scene::Camera& camera, const visibility::VisibleCells& visible) {
    std::vector<SeenSphere> seen;
    for (const visibility::VisibleCells::Part& part : visible.parts) {
        const visibility::Spheres spheres = visible.cells->spheres(part.cell);
        for (std::uint64_t slots = part.slots; slots != 0; slots &= slots - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
            const glm::dvec3 centre =
                glm::dvec3(spheres.x[slot], spheres.y[slot], spheres.z[slot]) - camera.position;
            seen.push_back(
                {centre, static_cast<double>(spheres.radius[slot]), -glm::dot(camera.back, centre)});
        }
    }
    return seen;
}

std::vector<ReceiverSlice> receiverSlices(const scene::Camera& camera, const scene::Frustum& frustum,
                                          std::span<const SeenSphere> seen) {
    std::vector<double> ends{std::exp2(std::floor(std::log2(camera.nearView)))};
    while (ends.back() < camera.farView) {
        ends.push_back(ends.back() * kSliceRatio);
    }
    return cutAt(ends, camera, frustum, seen);
}

std::vector<ReceiverSlice> slicesOf(ShadowMethod method, const scene::Camera& camera,
                                    const scene::Frustum& frustum, std::span<const SeenSphere> seen) {
    return method == ShadowMethod::plain ? practicalSlices(camera, frustum, seen)
                                         : receiverSlices(camera, frustum, seen);
}

} // namespace cdr::render
