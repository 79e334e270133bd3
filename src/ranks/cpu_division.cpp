#include <cdr/base/enum_names.h>

#include <ranks/cpu_division.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cdr::ranks {

namespace {

constexpr base::EnumNames<CpuChoice, 4> kChoices{"CPU choice",
                                                 {"unknown", "shared", "followed", "overlapping"}};

/// Ranks of a machine by their number on it, ascending.
using Group = std::vector<std::size_t>;

bool meet(const Cpus& a, const Cpus& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// Ranks that may use some of the same CPUs are in one group, be it by way of other ranks.
std::vector<Group> groupsOf(const std::vector<Cpus>& allowed) {
    std::vector<Group> groups;
    for (std::size_t rank = 0; rank < allowed.size(); ++rank) {
        Group joined;
        for (Group& group : groups) {
            if (std::any_of(group.begin(), group.end(),
                            [&](std::size_t other) { return meet(allowed[other], allowed[rank]); })) {
                joined.insert(joined.end(), group.begin(), group.end());
                group.clear();
            }
        }
        std::erase_if(groups, [](const Group& group) { return group.empty(); });
        joined.push_back(rank);
        std::sort(joined.begin(), joined.end());
        groups.push_back(joined);
    }
    return groups;
}

/// Neighbouring CPUs for each, whose numbers differ by one at most; the same CPU for some where there are too few.
void cut(const Cpus& cpus, const Group& group, std::vector<Cpus>& parts) {
    for (std::size_t i = 0; i < group.size(); ++i) {
        const std::size_t first = i * cpus.size() / group.size();
        const std::size_t end = std::max(first + 1, (i + 1) * cpus.size() / group.size());
        for (std::size_t k = first; k < end; ++k) {
            parts[group[i]].push_back(cpus[k]);
        }
    }
}

/// CPUs that few ranks may use are dealt first, each to the rank that has fewest so far.
void deal(const std::vector<Cpus>& allowed, const Group& group, std::vector<Cpus>& parts) {
    std::map<std::size_t, Group> usersOf;
    for (const std::size_t rank : group) {
        for (const std::size_t cpu : allowed[rank]) {
            usersOf[cpu].push_back(rank);
        }
    }
    std::vector<std::pair<std::size_t, Group>> cpus(usersOf.begin(), usersOf.end());
    std::stable_sort(cpus.begin(), cpus.end(),
                     [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    for (const auto& [cpu, users] : cpus) {
        parts[*std::min_element(users.begin(), users.end(), [&](std::size_t a, std::size_t b) {
            return parts[a].size() < parts[b].size();
        })].push_back(cpu);
    }
    for (const std::size_t rank : group) {
        if (parts[rank].empty()) {
            parts[rank] = {allowed[rank][rank % allowed[rank].size()]};
        }
        std::sort(parts[rank].begin(), parts[rank].end());
    }
}

} // namespace

std::string_view nameOf(CpuChoice choice) {
    return kChoices.nameOf(choice);
}

CpuDivision divideCpus(const std::vector<Cpus>& allowed) {
    CpuDivision division{.parts = std::vector<Cpus>(allowed.size())};
    if (std::any_of(allowed.begin(), allowed.end(), [](const Cpus& cpus) { return cpus.empty(); })) {
        return division;
    }
    division.choice = CpuChoice::followed;
    for (const Group& group : groupsOf(allowed)) {
        const Cpus& first = allowed[group.front()];
        const bool isAlike =
            std::all_of(group.begin(), group.end(), [&](std::size_t rank) { return allowed[rank] == first; });
        if (isAlike) {
            cut(first, group, division.parts);
        } else {
            deal(allowed, group, division.parts);
        }
        if (!isAlike) {
            division.choice = CpuChoice::overlapping;
        } else if (group.size() > 1 && division.choice == CpuChoice::followed) {
            division.choice = CpuChoice::shared;
        }
    }
    return division;
}

} // namespace cdr::ranks
