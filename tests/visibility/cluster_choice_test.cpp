#include "flat_cull.h"

#include <cdr/scene/lod/clusters.h>
#include <cdr/visibility/cluster_choice.h>
#include <cdr/visibility/level_choice.h>
#include <scenes/boulders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace {

using namespace cdr::scene;
using namespace cdr::visibility;
using cdr::depth::Cascades;

constexpr std::uint32_t kClusterHeight = 720;
const Cascades kThreeRanges{{0.5, 6.0}, {6.0, 9.0}, {9.0, 1000.0}};

/// The same boulder as it is, mirrored, stretched, with two sides, very far, and a small mesh without clusters.
Scene clusteredScene() {
    Scene scene;
    scene.meshes = {cdr::scenes::makeBoulder(4, 5), makeBox(glm::vec3(0.5f))};
    scene.materials = {Material{}, Material{.doubleSided = true}};
    const glm::mat3 one(1.0f);
    addInstance(scene, 0, 0, 0, {-5.0, 0.0, -6.0}, one); // cut by the picture's edge
    addInstance(scene, 0, 0, 1, {2.5, 0.5, -7.0}, glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    addInstance(scene, 1, 0, 2, {0.0, 1.0, -8.0}, one);
    addInstance(scene, 0, 0, 3, {0.5, -4.3, -9.0}, glm::mat3(2, 0, 0, 0.3f, 0.5f, 0, 0, 0, 1));
    addInstance(scene, 0, 1, 4, {0.0, 0.3, -2.5}, one);
    addInstance(scene, 0, 0, 5, {3.0, 3.0, -800.0}, one);
    cdr::platform::WorkerPool workers(2);
    makeClusters(scene, workers);
    return scene;
}

const Scene& theScene() {
    static const Scene scene = clusteredScene();
    return scene;
}

Camera theCamera() {
    return {.fovY = 0.9, .nearView = 0.5, .farView = 1000.0};
}

DrawLists chosen(double pixels, std::size_t threads = 1,
                 double wideSpan = std::numeric_limits<double>::infinity()) {
    const Camera camera = theCamera();
    const Frustum frustum = frustumOf(camera, kClusterHeight * 16.0 / 9.0, kClusterHeight);
    cdr::platform::WorkerPool workers(threads);
    DrawLists lists;
    binByDistance(flatCull(theScene().instances, camera, frustum), kThreeRanges, wideSpan, workers, lists);
    chooseDetail(theScene(),
                 {.camera = camera,
                  .frustum = frustum,
                  .clipRanges = kThreeRanges,
                  .wideSpan = wideSpan,
                  .levels = levelRule({.mode = DetailMode::perCluster, .pixels = pixels}, frustum)},
                 workers, lists);
    return lists;
}

/// Clusters by instance and cascade, those of runs one by one.
using ClustersDrawn = std::map<std::pair<std::uint32_t, std::size_t>, std::set<std::size_t>>;

ClustersDrawn clustersDrawn(const DrawLists& lists) {
    ClustersDrawn drawn;
    for (std::size_t cascade = 0; cascade < lists.cascades(); ++cascade) {
        const cdr::platform::IndexRange range = lists.range(cascade);
        for (std::size_t draw = range.begin; draw < range.end; ++draw) {
            const std::uint32_t instance = lists.instance[draw];
            const ClusterTree& tree = theScene().meshes[theScene().instances.mesh[instance]].clusters;
            const ClusterRun& run = lists.runs[draw];
            for (std::size_t i = 0; i < tree.clusters.size(); ++i) {
                const MeshCluster& cluster = tree.clusters[i];
                if (cluster.firstIndex >= run.firstIndex &&
                    cluster.firstIndex < run.firstIndex + run.indexCount) {
                    EXPECT_TRUE((drawn[{instance, cascade}].insert(i).second)) << "drawn twice";
                }
            }
        }
    }
    return drawn;
}

/// Whether a triangle is certain to cover nothing: it lies outside one plane, or shows its back.
bool isUnseen(const Instances& instances, std::uint32_t instance, const std::array<glm::dvec3, 3>& corners,
              bool hasBacks) {
    const Camera camera = theCamera();
    const Frustum frustum = frustumOf(camera, kClusterHeight * 16.0 / 9.0, kClusterHeight);
    std::array<glm::dvec3, 3> view;
    std::transform(corners.begin(), corners.end(), view.begin(), [&](const glm::dvec3& corner) {
        return glm::dmat3(instances.basis[instance]) * corner + instances.position(instance);
    });
    const auto areAll = [&](const auto& isOutside) { return std::ranges::all_of(view, isOutside); };
    const bool isOutside = areAll([&](const glm::dvec3& p) { return p.x > -p.z * frustum.tanX; }) ||
                           areAll([&](const glm::dvec3& p) { return p.x < p.z * frustum.tanX; }) ||
                           areAll([&](const glm::dvec3& p) { return p.y > -p.z * frustum.tanY; }) ||
                           areAll([&](const glm::dvec3& p) { return p.y < p.z * frustum.tanY; }) ||
                           areAll([&](const glm::dvec3& p) { return -p.z < camera.nearView; });
    const double mirrored = glm::determinant(glm::dmat3(instances.basis[instance])) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 normal = mirrored * glm::cross(view[1] - view[0], view[2] - view[0]);
    return isOutside || (hasBacks && glm::dot(normal, view[0]) >= -1e-9);
}

/// Whether a group may be drawn coarser, by the words of chooseClusters().
bool isCoarseEnough(std::uint32_t instance, const ClusterGroup& group, double pixels) {
    const Instances& instances = theScene().instances;
    const Mesh& mesh = theScene().meshes[instances.mesh[instance]];
    const double scale =
        static_cast<double>(instances.radius[instance]) / static_cast<double>(mesh.boundingRadius);
    const glm::dvec3 centre = instances.position(instance) +
                              glm::dmat3(instances.basis[instance]) * glm::dvec3(group.bounds.centre);
    const double nearest = std::max(-centre.z - static_cast<double>(group.bounds.radius) * scale, 0.5);
    return static_cast<double>(group.error) * scale / nearest * 0.5 * kClusterHeight / std::tan(0.45) <=
           pixels;
}

TEST(ClusterChoice, EveryPlaceHasTheCoarsestFormThatMayBe) {
    for (const double pixels : {0.3, 1.0, 4.0}) {
        const ClustersDrawn drawn = clustersDrawn(chosen(pixels));
        std::size_t unseen = 0;
        for (const std::uint32_t instance : {0u, 1u, 3u, 4u, 5u}) {
            const ClusterTree& tree = theScene().meshes[0].clusters;
            const bool hasBacks = !theScene().materials[theScene().instances.material[instance]].doubleSided;
            for (std::size_t i = 0; i < tree.clusters.size(); ++i) {
                const MeshCluster& cluster = tree.clusters[i];
                const bool stands = (cluster.madeBy == kNoGroup ||
                                     isCoarseEnough(instance, tree.groups[cluster.madeBy], pixels)) &&
                                    (cluster.coarserBy == kNoGroup ||
                                     !isCoarseEnough(instance, tree.groups[cluster.coarserBy], pixels));
                bool isDrawn = false;
                for (std::size_t cascade = 0; cascade < kThreeRanges.size(); ++cascade) {
                    const auto found = drawn.find({instance, cascade});
                    isDrawn = isDrawn || (found != drawn.end() && found->second.contains(i));
                }
                EXPECT_TRUE(stands || !isDrawn) << instance << ", cluster " << i;
                if (!stands || isDrawn) {
                    continue;
                }
                ++unseen;
                for (std::uint32_t k = 0; k < cluster.indexCount; k += 3) {
                    std::array<glm::dvec3, 3> corners;
                    for (std::uint32_t c = 0; c < 3; ++c) {
                        corners[c] = glm::dvec3(
                            theScene().meshes[0].vertices[tree.indices[cluster.firstIndex + k + c]].position);
                    }
                    EXPECT_TRUE(isUnseen(theScene().instances, instance, corners, hasBacks))
                        << instance << ", cluster " << i;
                }
            }
        }
        EXPECT_GT(unseen, 0u) << pixels; // something is left out
    }
}

/// A cluster is drawn in each cascade that holds a part of it.
TEST(ClusterChoice, NoCascadeLacksAPart) {
    const ClustersDrawn drawn = clustersDrawn(chosen(0.3));
    std::size_t inTwo = 0;
    for (const auto& [place, clusters] : drawn) {
        const auto& [instance, cascade] = place;
        for (const std::size_t i : clusters) {
            const MeshCluster& cluster = theScene().meshes[0].clusters.clusters[i];
            double nearest = 1e9;
            double farthest = 0.0;
            for (std::uint32_t k = 0; k < cluster.indexCount; ++k) {
                const std::uint32_t index = theScene().meshes[0].clusters.indices[cluster.firstIndex + k];
                const double w = -(theScene().instances.position(instance) +
                                   glm::dmat3(theScene().instances.basis[instance]) *
                                       glm::dvec3(theScene().meshes[0].vertices[index].position))
                                      .z;
                nearest = std::min(nearest, w);
                farthest = std::max(farthest, w);
            }
            for (std::size_t other = 0; other < kThreeRanges.size(); ++other) {
                if (farthest >= kThreeRanges[other].nearView && nearest <= kThreeRanges[other].farView) {
                    const auto found = drawn.find({instance, other});
                    EXPECT_TRUE(found != drawn.end() && found->second.contains(i));
                    inTwo += other != cascade ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(inTwo, 0u);
}

TEST(ClusterChoice, DrawsStayInInstanceOrderAndMeshesWithoutClustersStay) {
    constexpr double kSpan = 0.3; // whole boulders are wide, and many of their clusters are not
    const DrawLists lists = chosen(0.3, 1, kSpan);
    std::size_t boxes = 0;
    for (std::size_t bucket = 0; bucket + 1 < lists.begins.size(); ++bucket) {
        const auto first = lists.instance.begin();
        EXPECT_TRUE(std::is_sorted(first + static_cast<std::ptrdiff_t>(lists.begins[bucket]),
                                   first + static_cast<std::ptrdiff_t>(lists.begins[bucket + 1])));
        for (std::size_t draw = lists.begins[bucket]; draw < lists.begins[bucket + 1]; ++draw) {
            boxes += lists.instance[draw] == 2 && lists.runs[draw].indexCount == 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(boxes, 1u);
    std::size_t compactOfNear = 0; // the boulder of instance 4 spans more than its distance
    for (std::size_t draw = lists.begins[0]; draw < lists.begins[1]; ++draw) {
        compactOfNear += lists.instance[draw] == 4 ? 1 : 0;
    }
    EXPECT_GT(compactOfNear, 0u);
    EXPECT_EQ(clustersDrawn(lists), clustersDrawn(chosen(0.3)));
}

/// Each run is wide or not by its own clusters.
TEST(ClusterChoice, RunsAreWideByTheirClusters) {
    constexpr double kSpan = 0.1;
    const DrawLists lists = chosen(0.3, 1, kSpan);
    const ClusterTree& tree = theScene().meshes[0].clusters;
    std::array<std::size_t, 2> clusters{};
    for (std::size_t bucket = 0; bucket + 1 < lists.begins.size(); ++bucket) {
        for (std::size_t draw = lists.begins[bucket]; draw < lists.begins[bucket + 1]; ++draw) {
            const std::uint32_t instance = lists.instance[draw];
            const ClusterRun& run = lists.runs[draw];
            for (const MeshCluster& cluster : tree.clusters) {
                if (cluster.firstIndex < run.firstIndex ||
                    cluster.firstIndex >= run.firstIndex + run.indexCount) {
                    continue;
                }
                const Instances& instances = theScene().instances;
                const double w = -(instances.position(instance) +
                                   glm::dmat3(instances.basis[instance]) * glm::dvec3(cluster.bounds.centre))
                                      .z;
                const double radius = static_cast<double>(cluster.bounds.radius * instances.radius[instance] /
                                                          theScene().meshes[0].boundingRadius);
                const double excess = 2.0 * radius - kSpan * std::max(w - radius, 0.0);
                EXPECT_TRUE(std::abs(excess) < 1e-4 || (excess > 0.0) == (bucket % 2 == 1));
                ++clusters[bucket % 2];
            }
        }
    }
    EXPECT_GT(clusters[0], 0u);
    EXPECT_GT(clusters[1], 0u);
}

TEST(ClusterChoice, IsTheSameForAnyNumberOfThreads) {
    const DrawLists alone = chosen(0.5, 1, 0.3);
    for (const std::size_t threads : {2u, 5u}) {
        const DrawLists many = chosen(0.5, threads, 0.3);
        EXPECT_EQ(alone.instance, many.instance);
        EXPECT_EQ(alone.runs, many.runs);
        EXPECT_EQ(alone.begins, many.begins);
    }
}

TEST(ClusterChoice, NearPartsAreFiner) {
    const DrawLists lists = chosen(2.0);
    EXPECT_LT(trianglesDrawn(theScene(), lists), 5u * 20'480u / 2u);
    const ClustersDrawn drawn = clustersDrawn(lists);
    const auto errorsOf = [&](std::uint32_t instance) {
        std::set<float> errors;
        for (std::size_t cascade = 0; cascade < kThreeRanges.size(); ++cascade) {
            if (const auto found = drawn.find({instance, cascade}); found != drawn.end()) {
                for (const std::size_t i : found->second) {
                    const MeshCluster& cluster = theScene().meshes[0].clusters.clusters[i];
                    errors.insert(cluster.madeBy == kNoGroup
                                      ? 0.0f
                                      : theScene().meshes[0].clusters.groups[cluster.madeBy].error);
                }
            }
        }
        return errors;
    };
    EXPECT_GT(errorsOf(4).size(), 1u); // one instance, several levels
    EXPECT_LT(*errorsOf(4).begin(), *errorsOf(5).begin());
}

} // namespace
