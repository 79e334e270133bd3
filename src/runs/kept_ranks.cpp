#include "kept_ranks.h"

#include "shallow_cbor.h"
#include "units.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/base64.h>

#include <stdexcept>

namespace cdr::runs {

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
    m_file.emplace(path, std::move(digest));
    for (auto& [unit, made] : std::exchange(m_file->made(), {})) {
        m_kept[unit] = reading([&made = made] {
            auto bytes = platform::fromBase64(made.get_ref<const std::string&>());
            if (!bytes || !isShallowCbor(*bytes)) {
                throw std::out_of_range("not what a result is packed as");
            }
            return *std::move(bytes);
        });
    }
}

void KeptRanks::keepOnly(const std::function<bool(std::size_t unit, const platform::Bytes& made)>& stands) {
    std::erase_if(
        m_kept, [&](const auto& kept) { return !reading([&] { return stands(kept.first, kept.second); }); });
}

void KeptRanks::forEachUnit(std::size_t count, const Make& make, const Take& take) {
    handOver(&Ranks::forEachUnit, sharedOf(m_ranks, missingOf(count)), count, make, take);
}

void KeptRanks::forEachUnitOnFirst(std::size_t count, const Make& make, const Take& take) {
    handOver(&Ranks::forEachUnitOnFirst, missingOf(count), count, make, take);
}

void KeptRanks::forEachUnitTogether(std::size_t count, const Make& make, const Take& take) {
    handOver(&Ranks::forEachUnitTogether, sharedOf(m_ranks, missingOf(count)), count, make, take);
}

void KeptRanks::handOver(ForEach forEach, const Units& missing, std::size_t count, const Make& make,
                         const Take& take) {
    const std::size_t begin = std::exchange(m_begin, m_begin + count);
    std::size_t next = 0;
    const auto takeKeptBefore = [&](std::size_t unit) {
        for (; next < unit; ++next) {
            takeKept(next, begin, take);
        }
    };
    (m_ranks.*forEach)(
        missing.size(), [&](std::size_t i) { return make(missing[i]); },
        [&](std::size_t i, const platform::Bytes& made) {
            takeKeptBefore(missing[i]);
            take(missing[i], made);
            m_file->keep(begin + missing[i], platform::toBase64(m_form ? m_form(made) : made));
            ++next;
        });
    if (isFirst()) {
        takeKeptBefore(count);
    }
}

KeptRanks::Units KeptRanks::missingOf(std::size_t count) const {
    Units missing;
    for (std::size_t unit = 0; unit < count; ++unit) {
        if (!m_kept.contains(m_begin + unit)) {
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
