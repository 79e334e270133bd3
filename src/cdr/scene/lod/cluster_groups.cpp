#include <cdr/scene/lod/cluster_groups.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cdr::scene {

namespace {

/// How many points a cluster shares with each of its neighbours.
using SharedPoints = std::map<std::size_t, std::size_t>;

std::vector<SharedPoints> neighboursOf(std::span<const std::vector<std::uint32_t>> clusters,
                                       std::span<const std::uint32_t> places) {
    std::vector<std::pair<std::uint32_t, std::size_t>> users; // of a point
    for (std::size_t cluster = 0; cluster < clusters.size(); ++cluster) {
        for (const std::uint32_t index : clusters[cluster]) {
            users.emplace_back(places[index], cluster);
        }
    }
    std::sort(users.begin(), users.end());
    users.erase(std::unique(users.begin(), users.end()), users.end());
    std::vector<SharedPoints> neighbours(clusters.size());
    for (auto begin = users.begin(); begin != users.end();) {
        const auto end =
            std::find_if(begin, users.end(), [&](const auto& user) { return user.first != begin->first; });
        for (auto a = begin; a != end; ++a) {
            for (auto b = begin; b != end; ++b) {
                if (a != b) {
                    ++neighbours[a->second][b->second];
                }
            }
        }
        begin = end;
    }
    return neighbours;
}

} // namespace

std::vector<std::vector<std::size_t>> groupClusters(std::span<const std::vector<std::uint32_t>> clusters,
                                                    std::span<const std::uint32_t> places, std::size_t most) {
    const std::vector<SharedPoints> neighbours = neighboursOf(clusters, places);
    std::vector<bool> isTaken(clusters.size());
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t seed = 0; seed < clusters.size(); ++seed) {
        if (isTaken[seed]) {
            continue;
        }
        std::vector<std::size_t> group;
        SharedPoints candidates{{seed, 0}};
        while (group.size() < most && !candidates.empty()) {
            const auto best = std::ranges::max_element(
                candidates, [](const auto& a, const auto& b) { return a.second < b.second; });
            const std::size_t cluster = best->first;
            group.push_back(cluster);
            isTaken[cluster] = true;
            candidates.erase(best);
            for (const auto& [neighbour, points] : neighbours[cluster]) {
                if (!isTaken[neighbour]) {
                    candidates[neighbour] += points;
                }
            }
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

} // namespace cdr::scene
