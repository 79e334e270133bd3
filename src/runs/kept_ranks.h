#pragma once

#include <ranks/ranks.h>
#include <runs/unit_state.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::runs {

/// Ranks of a run whose results a file keeps: those of an earlier run are taken from there, and ranks make what is missing.
/// The first rank reads and writes the file. All ranks make the object, and share units through it alone.
class KeptRanks final : public ranks::Ranks {
  public:
    /// @param digest of everything that results depend on.
    /// base::InputError on the first rank as UnitStateFile, and where the file holds other results than of this class.
    KeptRanks(ranks::Ranks& ranks, const std::filesystem::path& path, std::string digest);

    /// Of the results of earlier runs.
    std::size_t keptCount() const { return m_kept.size(); }
    /// Before the first unit: forgets the results of earlier runs that do not stand any more, such as those whose files are gone.
    void keepOnly(const std::function<bool(const platform::Bytes& made)>& stands);

    void requireSame(const std::string& text, const std::string& otherwise) override;
    void learnMachine() override;
    void sayWhenKilled(const std::string& text) override { m_ranks.sayWhenKilled(text); }
    void forEachUnit(std::size_t count, const Make& make, const Take& take) override;
    void forEachUnitOnFirst(std::size_t count, const Make& make, const Take& take) override;
    platform::Bytes share(platform::Bytes ofFirst) override { return m_ranks.share(std::move(ofFirst)); }
    void merge(const std::function<platform::Bytes()>& pack,
               const std::function<void(const platform::Bytes& later)>& take) override;
    ranks::Ending end(const ranks::Ending& mine) override { return m_ranks.end(mine); }

  private:
    using Units = std::vector<std::size_t>;
    /// Of the next so many units of the run. Their results go through `make` on some rank, or come from the file.
    void handOver(std::size_t count, const Take& take,
                  const std::function<void(const Units& missing, const Take& taken)>& makeMissing);
    Units missingOf(std::size_t begin, std::size_t count) const;
    void takeKept(std::size_t unit, std::size_t begin, const Take& take);
    template <typename Action>
    auto reading(const Action& action) const;

    ranks::Ranks& m_ranks;
    std::filesystem::path m_path;
    std::optional<UnitStateFile> m_file;             ///< on the first rank
    std::map<std::size_t, platform::Bytes> m_kept{}; ///< by unit of the run; a result goes as it is taken
    std::size_t m_begin = 0;                         ///< unit of the run that the next call begins with
};

} // namespace cdr::runs
