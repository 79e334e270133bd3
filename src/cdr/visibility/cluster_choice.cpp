#include <cdr/visibility/cluster_choice.h>
#include <cdr/visibility/cluster_cut.h>
#include <cdr/visibility/landings.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobEntries = 64;

/// An entry of DrawLists.
struct Entry {
    std::uint32_t instance = 0;
    std::uint8_t level = 0;
    ClusterRun run{};
};

/// What one cascade draws.
struct Entries {
    std::vector<Entry> compact;
    std::vector<Entry> wide;

    void add(const Entry& entry, bool isWide) { (isWide ? wide : compact).push_back(entry); }
};

/// Appends entries of two lists, each in instance order, in that order.
void appendMerged(const std::vector<Entry>& a, const std::vector<Entry>& b, std::vector<Entry>& into) {
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(into),
               [](const Entry& x, const Entry& y) { return x.instance < y.instance; });
}

/// Puts runs of clusters in the place of draws.
class ClusterChoice {
  public:
    ClusterChoice(const scene::Scene& scene, const DetailView& view, platform::WorkerPool& workers,
                  DrawLists& lists)
        : m_scene(scene),
          m_view(view),
          m_test(view.camera, view.frustum),
          m_ranges(view.clipRanges, view.wideSpan),
          m_workers(workers),
          m_lists(lists),
          m_cuts(workers.threads()) {}

    void run() {
        std::vector<Entry> all;
        std::vector<std::size_t> begins{0};
        for (std::size_t cascade = 0; cascade < m_lists.cascades(); ++cascade) {
            // Wide instances have compact clusters and the other way round.
            const Entries ofCompact = replaced(cascade, 2 * cascade);
            const Entries ofWide = replaced(cascade, 2 * cascade + 1);
            appendMerged(ofCompact.compact, ofWide.compact, all);
            begins.push_back(all.size());
            appendMerged(ofCompact.wide, ofWide.wide, all);
            begins.push_back(all.size());
        }
        m_lists.begins = begins;
        m_lists.instance.clear();
        m_lists.level.clear();
        for (const Entry& entry : all) {
            m_lists.instance.push_back(entry.instance);
            m_lists.level.push_back(entry.level);
            m_lists.runs.push_back(entry.run);
        }
    }

  private:
    Entries replaced(std::size_t cascade, std::size_t bucket) {
        const std::size_t first = m_lists.begins[bucket];
        const std::size_t count = m_lists.begins[bucket + 1] - first;
        const std::size_t jobs = (count + kJobEntries - 1) / kJobEntries;
        std::vector<Entries> parts(jobs);
        m_workers.run(jobs, [&](std::size_t job, std::size_t worker) {
            const platform::IndexRange range = platform::evenRange(count, job, jobs);
            for (std::size_t i = first + range.begin; i < first + range.end; ++i) {
                const std::uint32_t instance = m_lists.instance[i];
                if (m_scene.meshes[m_scene.instances.mesh[instance]].clusters.clusters.empty()) {
                    parts[job].add({.instance = instance, .level = m_lists.level[i]}, bucket % 2 == 1);
                } else {
                    addRuns(instance, cascade, m_cuts[worker], parts[job]);
                }
            }
        });
        Entries all;
        for (const Entries& part : parts) {
            all.compact.insert(all.compact.end(), part.compact.begin(), part.compact.end());
            all.wide.insert(all.wide.end(), part.wide.begin(), part.wide.end());
        }
        return all;
    }

    void addRuns(std::uint32_t instance, std::size_t cascade, ClusterCut& cut, Entries& into) const {
        const scene::ClusterTree& tree = m_scene.meshes[m_scene.instances.mesh[instance]].clusters;
        const ClusterView view(m_scene, instance, m_test);
        ClusterRun run;
        bool isWide = false;
        const auto end = [&] {
            if (run.indexCount > 0) {
                into.add({.instance = instance, .run = run}, isWide);
            }
        };
        for (const std::uint32_t chosen : cut.of(tree, view, m_view.levels.slope)) {
            const scene::MeshCluster& cluster = tree.clusters[chosen];
            const ClusterView::Seen seen = view.see(cluster.bounds);
            const double low = seen.distanceView - seen.radius;
            const double high = seen.distanceView + seen.radius;
            if (m_ranges.farView[cascade] < low || m_ranges.nearView[cascade] > high) {
                continue;
            }
            const bool isClusterWide = high - low > m_ranges.wideSpan * std::max(low, 0.0);
            if (isClusterWide != isWide || run.firstIndex + run.indexCount != cluster.firstIndex) {
                end();
                run = {.firstIndex = cluster.firstIndex};
                isWide = isClusterWide;
            }
            run.indexCount += cluster.indexCount;
        }
        end();
    }

    const scene::Scene& m_scene;
    const DetailView& m_view;
    SphereTest m_test;
    LandingRanges m_ranges;
    platform::WorkerPool& m_workers;
    DrawLists& m_lists;
    std::vector<ClusterCut> m_cuts; ///< by worker
};

} // namespace

void chooseClusters(const scene::Scene& scene, const DetailView& view, platform::WorkerPool& workers,
                    DrawLists& lists) {
    const bool hasClusters = std::ranges::any_of(
        scene.meshes, [](const scene::Mesh& mesh) { return !mesh.clusters.clusters.empty(); });
    if (hasClusters) {
        ClusterChoice(scene, view, workers, lists).run();
    }
}

void chooseDetail(const scene::Scene& scene, const DetailView& view, platform::WorkerPool& workers,
                  DrawLists& lists) {
    chooseLevels(scene, view.camera, view.clipRanges, view.levels, workers, lists);
    if (view.levels.mode == DetailMode::perCluster) {
        chooseClusters(scene, view, workers, lists);
    }
}

} // namespace cdr::visibility
