#pragma once

#include <cdr/platform/file.h>

#include <ranks/cpu_division.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace cdr::ranks {

/// How a process ends: its exit status, and its line on standard error, which is empty where it has nothing to say.
struct Ending {
    int status = 0;
    std::string line{};
};

/// The ending that an error stands for.
using Explain = std::function<Ending(const std::exception_ptr& error)>;

/// Prints a line on standard error, from any thread.
using Say = std::function<void(const std::string& line)>;

/// Thrown where another rank has ended the run. The first rank says why.
class EndedElsewhere : public std::exception {
  public:
    const char* what() const noexcept override { return "another rank ended the run"; }
};

/// Where a process stands among those of a run.
struct Place {
    std::size_t index = 0; ///< of the rank, from 0; the first one prints and writes
    std::size_t count = 1;
    std::size_t indexOnNode = 0;
    std::size_t countOnNode = 1;
    std::optional<std::string> node{}; ///< name of its machine; none for a process that was started alone
    CpuDivision
        cpus{}; ///< of its machine; nothing is known before learnMachine(), and for a process that was started alone
};

/// The processes that one command was started as, its ranks; a process that was started alone is the first and only one.
///
/// All ranks run the same program on the same arguments, and call the functions below in the same order. Each
/// function that waits for other ranks throws if one of them has failed. On the first rank the error names the rank and
/// the cause; on the others it is EndedElsewhere.
class Ranks {
  public:
    /// The result of a unit.
    using Make = std::function<platform::Bytes(std::size_t unit)>;
    using Take = std::function<void(std::size_t unit, const platform::Bytes& made)>;
    /// forEachUnit(), forEachUnitOnFirst() or forEachUnitTogether().
    using ForEach = void (Ranks::*)(std::size_t count, const Make& make, const Take& take);

    explicit Ranks(const Place& place) : m_place(place) {}
    virtual ~Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    const Place& place() const { return m_place; }
    bool isFirst() const { return m_place.index == 0; }
    bool isAlone() const { return m_place.count == 1; }

    /// Makes each of `count` independent units on some rank; a rank is given units in ascending order. The first rank
    /// makes units too, and takes all results, in the order of the units.
    virtual void forEachUnit(std::size_t count, const Make& make, const Take& take) = 0;

    /// The same, but the first rank makes all of them, while the others go on.
    virtual void forEachUnitOnFirst(std::size_t count, const Make& make, const Take& take) {
        for (std::size_t unit = 0; isFirst() && unit < count; ++unit) {
            take(unit, make(unit));
        }
    }

    /// The same, but all ranks make each unit together. What make() gives on the first rank is the result.
    virtual void forEachUnitTogether(std::size_t count, const Make& make, const Take& take) {
        for (std::size_t unit = 0; unit < count; ++unit) {
            const platform::Bytes made = make(unit);
            if (isFirst()) {
                take(unit, made);
            }
        }
    }

    /// The bytes of the first rank, on every rank.
    virtual platform::Bytes share(platform::Bytes ofFirst) = 0;

    /// Brings what all ranks hold to the first one, in a tree. A rank takes what ranks after it hold, in their order. Then it
    /// hands on all that it holds.
    /// @param pack what this rank holds. @param take adds what later ranks packed.
    virtual void merge(const std::function<platform::Bytes()>& pack,
                       const std::function<void(const platform::Bytes& later)>& take) = 0;

  protected:
    void setCpus(CpuDivision cpus) { m_place.cpus = std::move(cpus); }

  private:
    Place m_place;
};

/// The same, with what belongs to the process and not to the work that it shares.
class Run : public Ranks {
  public:
    using Ranks::Ranks;

    /// base::InputError on the first rank unless all give the same text.
    /// @param otherwise what is said of a rank that gives another one than the first.
    virtual void requireSame(const std::string& text, const std::string& otherwise) = 0;

    /// Fills place().cpus. From here on a rank that is killed is named by another one of its machine. After requireSame():
    /// ranks of other versions may have another way to learn it.
    virtual void learnMachine() = 0;

    /// What the line ends with that names a killed rank, such as what of the run is kept; on every rank, after
    /// learnMachine().
    virtual void sayWhenKilled(const std::string& text) = 0;

    /// The last call of a run: waits for all ranks. If one of them failed, all end as it does.
    /// @param mine how this rank ends, or would end alone.
    virtual Ending end(const Ending& mine) = 0;
};

} // namespace cdr::ranks
