#include "kept_ranks.h"

#include "units.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/base64.h>

#include <limits>
#include <stdexcept>

namespace cdr::runs {

namespace {

/// Only the commands know how many units a run has.
constexpr std::size_t kAnyCount = std::numeric_limits<std::size_t>::max();

} // namespace

/// What is read has the right sums, and may be of another shape all the same.
template <typename Action>
auto KeptRanks::reading(const Action& action) const {
    try {
        return action();
    } catch (const output::Json::exception&) {
    } catch (const std::out_of_range&) {
    }
    throw base::inputError("{}: holds results that do not fit this run; remove it or name another file",
                           m_path.string());
}

KeptRanks::KeptRanks(ranks::Ranks& ranks, const std::filesystem::path& path, std::string digest)
    : Ranks(ranks.place()),
      m_ranks(ranks),
      m_path(path) {
    if (!isFirst()) {
        return;
    }
    m_file.emplace(path, UnitRun{.digest = std::move(digest), .units = kAnyCount});
    for (auto& [unit, made] : std::exchange(m_file->made(), {})) {
        m_kept[unit] = reading([&made = made] {
            return platform::fromBase64(made.get_ref<const std::string&>()).value_or(platform::Bytes());
        });
    }
}

void KeptRanks::keepOnly(const std::function<bool(const platform::Bytes& made)>& stands) {
    std::erase_if(m_kept, [&](const auto& kept) { return !reading([&] { return stands(kept.second); }); });
}

void KeptRanks::requireSame(const std::string& text, const std::string& otherwise) {
    m_ranks.requireSame(text, otherwise);
}

void KeptRanks::learnMachine() {
    m_ranks.learnMachine();
    setCpus(m_ranks.place().cpus);
}

void KeptRanks::forEachUnit(std::size_t count, const Make& make, const Take& take) {
    handOver(count, take, [&](const Units& ofFirst, const Take& taken) {
        const Units missing = sharedOf(m_ranks, ofFirst);
        m_ranks.forEachUnit(
            missing.size(), [&](std::size_t i) { return make(missing[i]); },
            [&](std::size_t i, const platform::Bytes& made) { taken(missing[i], made); });
    });
}

void KeptRanks::forEachUnitOnFirst(std::size_t count, const Make& make, const Take& take) {
    handOver(count, take, [&](const Units& missing, const Take& taken) {
        m_ranks.forEachUnitOnFirst(
            missing.size(), [&](std::size_t i) { return make(missing[i]); },
            [&](std::size_t i, const platform::Bytes& made) { taken(missing[i], made); });
    });
}

void KeptRanks::handOver(std::size_t count, const Take& take,
                         const std::function<void(const Units& missing, const Take& taken)>& makeMissing) {
    const std::size_t begin = std::exchange(m_begin, m_begin + count);
    std::size_t next = 0;
    const auto takeKeptBefore = [&](std::size_t unit) {
        for (; next < unit; ++next) {
            takeKept(next, begin, take);
        }
    };
    makeMissing(missingOf(begin, count), [&](std::size_t unit, const platform::Bytes& made) {
        takeKeptBefore(unit);
        take(unit, made);
        m_file->keep(begin + unit, platform::toBase64(made));
        ++next;
    });
    if (isFirst()) {
        takeKeptBefore(count);
    }
}

KeptRanks::Units KeptRanks::missingOf(std::size_t begin, std::size_t count) const {
    Units missing;
    for (std::size_t unit = 0; unit < count; ++unit) {
        if (!m_kept.contains(begin + unit)) {
            missing.push_back(unit);
        }
    }
    return missing;
}

void KeptRanks::takeKept(std::size_t unit, std::size_t begin, const Take& take) {
    const auto kept = m_kept.extract(begin + unit);
    reading([&] { take(unit, kept.mapped()); });
}

void KeptRanks::merge(const std::function<platform::Bytes()>& pack,
                      const std::function<void(const platform::Bytes& later)>& take) {
    m_ranks.merge(pack, take);
}

} // namespace cdr::runs
