#include <cdr/render/shadows/receiver_slices.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace cdr::render {

namespace {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& centre, double radius) {
        low = glm::min(low, centre - radius);
        high = glm::max(high, centre + radius);
    }
    std::array<glm::dvec3, 8> corners() const {
        std::array<glm::dvec3, 8> all;
        for (int i = 0; i < 8; ++i) {
            all[static_cast<std::size_t>(i)] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                                (i & 4) != 0 ? high.z : low.z};
        }
        return all;
    }
};

int sliceAt(double distanceView) {
    return static_cast<int>(std::floor(std::log2(distanceView) / std::log2(kSliceRatio)));
}

double endOf(int slice) {
    return std::pow(kSliceRatio, slice);
}

std::array<glm::dvec3, 8> cornersOf(const scene::Camera& camera, const scene::Frustum& frustum,
                                    double nearView, double farView) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const double w = (i & 4) != 0 ? farView : nearView;
        const double x = ((i & 1) != 0 ? 1.0 : -1.0) * frustum.tanX * w;
        const double y = ((i & 2) != 0 ? 1.0 : -1.0) * frustum.tanY * w;
        corners[static_cast<std::size_t>(i)] = camera.right * x + camera.up * y - camera.back * w;
    }
    return corners;
}

/// Where the surfaces of a slice are: what its part of the frustum and the box around spheres have in common, each taken as
/// a box along the camera's axes.
void placeReceivers(const scene::Camera& camera, ReceiverSlice& slice) {
    Box view;
    Box boxes;
    const auto along = [&](const glm::dvec3& corner) {
        return glm::dvec3(glm::dot(camera.right, corner), glm::dot(camera.up, corner),
                          glm::dot(camera.back, corner));
    };
    for (std::size_t i = 0; i < slice.view.size(); ++i) {
        view.add(along(slice.view[i]), 0.0);
        boxes.add(along(slice.boxes[i]), 0.0);
    }
    const glm::dvec3 low = glm::max(view.low, boxes.low);
    const glm::dvec3 high = glm::max(glm::min(view.high, boxes.high), low);
    const glm::dvec3 middle = 0.5 * (low + high);
    slice.middle = camera.right * middle.x + camera.up * middle.y + camera.back * middle.z;
    slice.reach = 0.5 * glm::distance(low, high);
}

} // namespace

std::vector<ReceiverSlice> receiverSlices(const scene::Camera& camera, const scene::Frustum& frustum,
                                          const visibility::VisibleCells& visible) {
    const int first = sliceAt(camera.nearView);
    const int last = sliceAt(camera.farView);
    std::map<int, Box> boxes; // by slice
    for (const visibility::VisibleCells::Part& part : visible.parts) {
        const visibility::Spheres spheres = visible.cells->spheres(part.cell);
        for (std::uint64_t slots = part.slots; slots != 0; slots &= slots - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
            const glm::dvec3 centre =
                glm::dvec3(spheres.x[slot], spheres.y[slot], spheres.z[slot]) - camera.position;
            const auto radius = static_cast<double>(spheres.radius[slot]);
            const double distanceView = -glm::dot(camera.back, centre);
            const int begin =
                distanceView - radius > camera.nearView ? sliceAt(distanceView - radius) : first;
            const int end = distanceView + radius > camera.nearView ? sliceAt(distanceView + radius) : first;
            for (int slice = std::max(begin, first); slice <= std::min(end, last); ++slice) {
                boxes[slice].add(centre, radius);
            }
        }
    }
    std::vector<ReceiverSlice> slices;
    for (const auto& [slice, box] : boxes) {
        const double nearView = endOf(slice);
        const double farView = endOf(slice + 1);
        slices.push_back({.nearView = nearView,
                          .farView = farView,
                          .view = cornersOf(camera, frustum, std::max(nearView, camera.nearView),
                                            std::min(farView, camera.farView)),
                          .boxes = box.corners()});
        placeReceivers(camera, slices.back());
    }
    return slices;
}

} // namespace cdr::render
