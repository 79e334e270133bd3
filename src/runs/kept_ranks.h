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
    /// base::InputError on the first rank as UnitStateFile, and where the file holds other results than CBOR of this class.
    KeptRanks(ranks::Ranks& ranks, const std::filesystem::path& path, std::string digest);

    /// Of the results of earlier runs.
    std::size_t keptCount() const { return m_kept.size(); }
    /// Before the first unit: forgets the results of earlier runs that do not stand any more, such as those whose files are gone.
    /// @param stands is given a unit of the run. Json::exception or std::out_of_range where its result does not fit this run.
    void keepOnly(const std::function<bool(std::size_t unit, const platform::Bytes& made)>& stands);
    /// Before the first unit: what the file keeps of a result; all of it where this was not called.
    void keepAs(std::function<platform::Bytes(const platform::Bytes& made)> form) {
        m_form = std::move(form);
    }

    void forEachUnit(std::size_t count, const Make& make, const Take& take) override;
    void forEachUnitOnFirst(std::size_t count, const Make& make, const Take& take) override;
    void forEachUnitTogether(std::size_t count, const Make& make, const Take& take) override;
    platform::Bytes share(platform::Bytes ofFirst) override { return m_ranks.share(std::move(ofFirst)); }
    void merge(const std::function<platform::Bytes()>& pack,
               const std::function<void(const platform::Bytes& later)>& take) override;

  private:
    using Units = std::vector<std::size_t>;
    /// Of the next so many units of the run. Those that are missing are made by ranks, the others come from the file.
    void handOver(ForEach forEach, const Units& missing, std::size_t count, const Make& make,
                  const Take& take);
    Units missingOf(std::size_t count) const; ///< of the next so many
    void takeKept(std::size_t unit, std::size_t begin, const Take& take);
    template <typename Action>
    auto reading(const Action& action) const;

    ranks::Ranks& m_ranks;
    std::filesystem::path m_path;
    std::optional<UnitStateFile> m_file; ///< on the first rank
    std::function<platform::Bytes(const platform::Bytes& made)> m_form{};
    std::map<std::size_t, platform::Bytes> m_kept{}; ///< by unit of the run; a result goes as it is taken
    std::size_t m_begin = 0;                         ///< unit of the run that the next call begins with
};

} // namespace cdr::runs
