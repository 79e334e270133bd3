#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/lod/clusters.h>
#include <cdr/scene/lod/levels.h>
#include <cdr/visibility/level_choice.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobDraws = 16'384;
constexpr base::EnumNames<DetailMode, kDetailModes.size()> kNames{"detail",
                                                                  {"none", "object", "cascade", "cluster"}};

/// View distance of an instance's centre, by cullSpheres()' operations in their order.
double distanceOf(const scene::Instances& instances, std::uint32_t instance, const scene::Camera& camera) {
    const double dx = instances.x[instance] - camera.position.x;
    const double dy = instances.y[instance] - camera.position.y;
    const double dz = instances.z[instance] - camera.position.z;
    return -(dx * camera.back.x + dy * camera.back.y + dz * camera.back.z);
}

/// The coarsest level that may be used at a view distance. An error's share of the mesh's bounding radius is
/// the share that its world-space size has of the instance's radius. Products instead of that quotient are
/// the same on the device.
std::uint8_t levelAt(const scene::Scene& scene, std::uint32_t instance, double distanceView, double slope) {
    const scene::Mesh& mesh = scene.meshes[scene.instances.mesh[instance]];
    const auto radius = static_cast<double>(scene.instances.radius[instance]);
    const double limit = slope * distanceView * static_cast<double>(mesh.boundingRadius);
    for (std::size_t level = mesh.levels.size(); level > 0; --level) {
        if (static_cast<double>(mesh.levels[level - 1].error) * radius <= limit) {
            return static_cast<std::uint8_t>(level);
        }
    }
    return 0;
}

} // namespace

std::string_view nameOf(DetailMode mode) {
    return kNames.nameOf(mode);
}

std::string nameOf(const Detail& detail) {
    const std::string_view name = nameOf(detail.mode);
    return detail.mode == DetailMode::none ? std::string(name) : fmt::format("{}:{}", name, detail.pixels);
}

Detail parseDetail(std::string_view text) {
    const std::size_t colon = text.find(':');
    Detail detail{.mode = kNames.parse(text.substr(0, colon))};
    if (colon != std::string_view::npos) {
        if (detail.mode == DetailMode::none) {
            throw base::InputError("detail none takes no pixels");
        }
        detail.pixels = base::parseNumber("detail pixels", std::string(text.substr(colon + 1)));
    }
    requireUsable(detail);
    return detail;
}

void requireUsable(const Detail& detail) {
    if (!std::isfinite(detail.pixels) || detail.pixels <= 0.0) {
        throw base::inputError("detail pixels must be finite and above 0, not {}", detail.pixels);
    }
}

void prepareDetail(scene::Scene& scene, DetailMode mode, platform::WorkerPool& workers) {
    if (mode == DetailMode::perCluster) {
        scene::makeClusters(scene, workers);
    }
    if (mode != DetailMode::none) {
        scene::makeLevels(scene, workers);
    }
}

LevelRule levelRule(const Detail& detail, const scene::Frustum& frustum) {
    return {.mode = detail.mode, .slope = detail.pixels * frustum.footprintSlope};
}

std::uint8_t levelOf(const scene::Scene& scene, std::uint32_t instance, const scene::Camera& camera,
                     const LevelRule& rule) {
    if (rule.mode == DetailMode::none) {
        return 0;
    }
    const auto radius = static_cast<double>(scene.instances.radius[instance]);
    const double nearestView =
        std::max(distanceOf(scene.instances, instance, camera) - radius, camera.nearView);
    return levelAt(scene, instance, nearestView, rule.slope);
}

void chooseLevels(const scene::Scene& scene, const scene::Camera& camera, const depth::Cascades& clipRanges,
                  const LevelRule& rule, platform::WorkerPool& workers, DrawLists& lists) {
    lists.runs.clear();
    if (rule.mode == DetailMode::none) {
        lists.level.clear();
        return;
    }
    lists.level.resize(std::max(lists.level.size(), lists.draws()));
    for (std::size_t cascade = 0; cascade < lists.cascades(); ++cascade) {
        const platform::IndexRange all = lists.range(cascade);
        const std::size_t jobs = (all.size() + kJobDraws - 1) / kJobDraws;
        workers.run(jobs, [&](std::size_t job, std::size_t) {
            const platform::IndexRange range = platform::evenRange(all.size(), job, jobs);
            for (std::size_t draw = all.begin + range.begin; draw < all.begin + range.end; ++draw) {
                const std::uint32_t instance = lists.instance[draw];
                lists.level[draw] = rule.mode == DetailMode::perCascade
                                        ? levelAt(scene, instance, clipRanges[cascade].nearView, rule.slope)
                                        : levelOf(scene, instance, camera, rule);
            }
        });
    }
}

std::uint64_t trianglesDrawn(const scene::Scene& scene, const DrawLists& lists) {
    std::uint64_t indices = 0;
    for (std::size_t draw = 0; draw < lists.draws(); ++draw) {
        if (!lists.runs.empty() && lists.runs[draw].indexCount > 0) {
            indices += lists.runs[draw].indexCount;
            continue;
        }
        const scene::Mesh& mesh = scene.meshes[scene.instances.mesh[lists.instance[draw]]];
        const std::size_t level = lists.level.empty() ? 0 : lists.level[draw];
        indices += level == 0 ? mesh.indices.size() : mesh.levels[level - 1].indices.size();
    }
    return indices / 3;
}

} // namespace cdr::visibility
