#include <cdr/base/format_error.h>

#include <climits>
#include <fmt/format.h>
#include <mpi.h>
#include <ranks/join.h>
#include <ranks/mpi_counters.h>
#include <ranks/mpi_machine.h>
#include <ranks/mpi_ranks.h>
#include <ranks/rank_watch.h>
#include <ranks/unit_order.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace cdr::ranks {

namespace {

/// Added to the counter of units, so that no more are claimed: more than there are units, and far from overflowing.
constexpr std::uint64_t kStop = std::uint64_t{1} << 40u;
/// Units that a rank may be ahead of what the first rank has taken, times the number of ranks.
constexpr std::uint64_t kAheadOfEach = 8;
/// Between two looks at whether something has arrived. MPI's own waits keep a processor busy, which another rank may need.
constexpr auto kPause = std::chrono::milliseconds(1);

enum Tag : int { kMadeTag = 1, kDoneTag = 2, kMergedTag = 3 };

/// What a rank tells of itself where ranks meet; of one size, so that it needs no second message.
struct Word {
    std::int32_t status = 0;
    std::int32_t isLast = 0; ///< whether the rank has come to its end
    std::array<char, 1000> line{};
};

Word wordOf(const Ending& ending) {
    Word word{.status = ending.status};
    ending.line.copy(word.line.data(), word.line.size() - 1);
    return word;
}

Word lastWordOf(const Ending& ending) {
    Word word = wordOf(ending);
    word.isLast = 1;
    return word;
}

/// MPI as long as it lives. MPI calls of one thread at a time.
class MpiLifetime {
  public:
    MpiLifetime() {
        int level = MPI_THREAD_SINGLE;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
        if (level < MPI_THREAD_SERIALIZED) {
            MPI_Finalize();
            throw base::RunError("this MPI does not support threads (MPI_THREAD_SERIALIZED)");
        }
    }
    ~MpiLifetime() { MPI_Finalize(); }
    MpiLifetime(const MpiLifetime&) = delete;
    MpiLifetime& operator=(const MpiLifetime&) = delete;
};

class MpiRanks final : public Run {
  public:
    MpiRanks(std::unique_ptr<HeldSignals> signals, std::unique_ptr<MpiLifetime> lifetime, Explain explain,
             Say say)
        : Run(placeAmongAll()),
          m_signals(std::move(signals)),
          m_lifetime(std::move(lifetime)),
          m_explain(std::move(explain)),
          m_say(std::move(say)) {}

    void requireSame(const std::string& text, const std::string& otherwise) override {
        const platform::Bytes own(text.begin(), text.end());
        const platform::Bytes first = share(own);
        meet(first == own ? Ending{} : Ending{.status = 2, .line = otherwise});
    }

    void learnMachine() override {
        meet({});
        m_machine.emplace();
        setCpus(divideCpus(m_machine->cpusOfRanks()));
        if (isAlone()) {
            m_signals.reset();
            return;
        }
        std::vector<std::string> names;
        for (const std::size_t rank : m_machine->numbersOfRanks()) {
            names.push_back(fmt::format("rank {} of {} on {}", rank, place().count, *place().node));
        }
        m_watch.emplace(names, place().indexOnNode, m_machine->sharedLife(), m_machine->locks(), *m_signals,
                        m_say);
    }

    void sayWhenKilled(const std::string& text) override {
        if (m_watch) {
            m_watch->append(text);
        }
    }

    void forEachUnit(std::size_t count, const Make& make, const Take& take) override {
        if (isFirst()) {
            m_counters.set(MpiCounters::next, 0);
            m_counters.set(MpiCounters::taken, 0);
        }
        meet({});
        Word verdict;
        if (isFirst()) {
            verdict = lead(count, make, take);
        } else {
            follow(count, make);
        }
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Ibcast(&verdict, sizeof verdict, MPI_BYTE, 0, MPI_COMM_WORLD, &request);
        sleepUntilDone(request);
        requireWell(verdict);
    }

    platform::Bytes share(platform::Bytes ofFirst) override {
        meet({});
        return broadcast(std::move(ofFirst));
    }

    void merge(const std::function<platform::Bytes()>& pack,
               const std::function<void(const platform::Bytes& later)>& take) override {
        meet({});
        std::exception_ptr failed;
        std::size_t step = 1;
        for (; place().index % (2 * step) == 0 && step < place().count; step *= 2) {
            if (place().index + step < place().count) {
                const platform::Bytes later = receiveMerged(static_cast<int>(place().index + step));
                attempt(failed, [&] { take(later); });
            }
        }
        if (!isFirst()) {
            platform::Bytes mine; // none, where packing failed: nobody will use it
            attempt(failed, [&] {
                platform::Bytes packed = pack();
                countOf(packed); // throws where MPI cannot send so much
                mine = std::move(packed);
            });
            MPI_Request request = MPI_REQUEST_NULL;
            MPI_Isend(mine.data(), countOf(mine), MPI_BYTE, static_cast<int>(place().index - step),
                      kMergedTag, MPI_COMM_WORLD, &request);
            sleepUntilDone(request);
        }
        m_own = isFirst() ? failed : nullptr;
        meet(failed ? m_explain(failed) : Ending{});
    }

    Ending end(const Ending& mine) override {
        Ending ending{.status = m_status, .line = mine.line};
        if (!m_isOver) {
            const Word first = firstFailure(exchange(lastWordOf(named(mine))));
            ending = {.status = first.status, .line = first.line.data()};
        }
        m_watch.reset();
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Ibarrier(MPI_COMM_WORLD, &request);
        sleepUntilDone(request);
        m_signals.reset();
        return {.status = ending.status, .line = isFirst() ? ending.line : ""};
    }

  private:
    /// Results of other ranks on their way to the first.
    struct Inbox {
        std::mutex mutex;
        std::vector<std::pair<std::size_t, platform::Bytes>> made{};
        std::vector<Word> endings{}; ///< of the ranks that will send no more
    };

    static void sleepUntilDone(MPI_Request request) {
        int isDone = 0;
        while (MPI_Test(&request, &isDone, MPI_STATUS_IGNORE), isDone == 0) {
            std::this_thread::sleep_for(kPause);
        }
    }

    std::vector<Word> exchange(const Word& mine) const {
        std::vector<Word> words(place().count);
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Iallgather(&mine, sizeof mine, MPI_BYTE, words.data(), sizeof mine, MPI_BYTE, MPI_COMM_WORLD,
                       &request);
        sleepUntilDone(request);
        return words;
    }

    /// One of status 0 where all are well.
    static Word firstFailure(const std::vector<Word>& words) {
        const auto failed = std::ranges::find_if(words, [](const Word& word) { return word.status != 0; });
        return failed != words.end() ? *failed : Word{};
    }

    /// Waits for all ranks and learns whether each is well.
    void meet(const Ending& mine) {
        const std::vector<Word> words = exchange(wordOf(named(mine)));
        Word first = firstFailure(words);
        if (first.status == 0 &&
            std::any_of(words.begin(), words.end(), [](const Word& word) { return word.isLast != 0; })) {
            first = wordOf({.status = 1, .line = "ranks did different work; was a file changed meanwhile?"});
        }
        requireWell(first);
    }

    void requireWell(const Word& word) {
        if (word.status == 0) {
            return;
        }
        m_isOver = true;
        m_status = word.status;
        if (!isFirst()) {
            throw EndedElsewhere();
        }
        if (m_own) {
            std::rethrow_exception(std::exchange(m_own, nullptr));
        }
        if (word.status == 2) {
            throw base::InputError(word.line.data());
        }
        throw base::RunError(word.line.data());
    }

    /// With the rank in front; the first rank's errors read as if it were alone.
    Ending named(const Ending& ending) const {
        return isFirst() || ending.line.empty()
                   ? ending
                   : Ending{.status = ending.status,
                            .line =
                                fmt::format("rank {} on {}: {}", place().index, *place().node, ending.line)};
    }

    static platform::Bytes broadcast(platform::Bytes bytes) {
        std::uint64_t size = bytes.size();
        MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
        bytes.resize(size);
        MPI_Bcast(bytes.data(), countOf(bytes), MPI_BYTE, 0, MPI_COMM_WORLD);
        return bytes;
    }

    /// Notes what goes wrong, since other ranks wait for this one all the same.
    template <typename Action>
    static void attempt(std::exception_ptr& failed, const Action& action) {
        if (failed) {
            return;
        }
        try {
            action();
        } catch (...) {
            failed = std::current_exception();
        }
    }

    /// Like MPI itself it does not go on without memory: the rank that sends would wait forever.
    static platform::Bytes receiveMerged(int from) noexcept {
        MPI_Message message = MPI_MESSAGE_NULL;
        MPI_Status status;
        int isThere = 0;
        while (MPI_Improbe(from, kMergedTag, MPI_COMM_WORLD, &isThere, &message, &status), isThere == 0) {
            std::this_thread::sleep_for(kPause);
        }
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        platform::Bytes bytes(static_cast<std::size_t>(size));
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Imrecv(bytes.data(), size, MPI_BYTE, &message, &request);
        sleepUntilDone(request);
        return bytes;
    }

    static int countOf(const platform::Bytes& bytes) {
        if (bytes.size() > INT_MAX) {
            throw base::runError("{} bytes are too many for one message of MPI", bytes.size());
        }
        return static_cast<int>(bytes.size());
    }

    std::uint64_t claim() {
        const std::lock_guard lock(m_mpi);
        return m_counters.add(MpiCounters::next, 1);
    }

    void stop() {
        const std::lock_guard lock(m_mpi);
        m_counters.add(MpiCounters::next, kStop);
    }

    /// Waits until a unit is near to those that the first rank has taken, which holds what comes early.
    /// @param idle called meanwhile. @return false where no more units are to be made.
    template <typename Action>
    bool waitUntilNear(std::uint64_t unit, const Action& idle) {
        for (;; std::this_thread::sleep_for(kPause)) {
            {
                const std::lock_guard lock(m_mpi);
                if (m_counters.get(MpiCounters::next) >= kStop) {
                    return false;
                }
                if (unit < m_counters.get(MpiCounters::taken) + kAheadOfEach * place().count) {
                    return true;
                }
            }
            idle();
        }
    }

    /// Makes units and sends them to the first rank; last how that went.
    void follow(std::size_t count, const Make& make) {
        Word word;
        try {
            for (std::uint64_t unit = claim(); unit < count && waitUntilNear(unit, [] {}); unit = claim()) {
                platform::Bytes made = make(unit);
                const auto* number = reinterpret_cast<const std::uint8_t*>(&unit);
                made.insert(made.end(), number, number + sizeof unit);
                MPI_Send(made.data(), countOf(made), MPI_BYTE, 0, kMadeTag, MPI_COMM_WORLD);
            }
        } catch (...) {
            stop();
            word = wordOf(named(m_explain(std::current_exception())));
        }
        MPI_Send(&word, sizeof word, MPI_BYTE, 0, kDoneTag, MPI_COMM_WORLD);
    }

    /// Makes units, while a thread receives those of other ranks. That thread also serves their claims, where the
    /// network needs this rank's doing for it.
    Word lead(std::size_t count, const Make& make, const Take& take) {
        Inbox inbox;
        std::jthread receiver([&] { receiveAll(inbox); });
        UnitOrder order;
        const auto handOn = [&] {
            order.handOn(take);
            const std::lock_guard lock(m_mpi);
            m_counters.set(MpiCounters::taken, order.done());
        };
        const auto handOnWhatCame = [&] {
            sort(inbox, order);
            handOn();
        };
        try {
            for (std::uint64_t unit = claim(); unit < count && waitUntilNear(unit, handOnWhatCame);
                 unit = claim()) {
                order.put(unit, make(unit));
                handOnWhatCame();
            }
            while (!sort(inbox, order)) {
                handOn();
                std::this_thread::sleep_for(kPause);
            }
            handOn();
        } catch (...) {
            stop();
            m_own = std::current_exception();
        }
        receiver.join();
        return m_own ? wordOf(m_explain(m_own)) : firstFailure(inbox.endings);
    }

    /// Whether all other ranks have sent their last.
    bool sort(Inbox& inbox, UnitOrder& order) const {
        const std::lock_guard lock(inbox.mutex);
        for (auto& [unit, made] : inbox.made) {
            order.put(unit, std::move(made));
        }
        inbox.made.clear();
        return inbox.endings.size() + 1 == place().count;
    }

    /// Until each other rank has sent its last. Like MPI itself it does not go on without memory.
    void receiveAll(Inbox& inbox) noexcept {
        for (std::size_t open = place().count - 1; open > 0;) {
            const int tag = receiveOne(inbox);
            open -= tag == kDoneTag ? 1 : 0;
            if (tag == 0) {
                std::this_thread::sleep_for(kPause);
            }
        }
    }

    /// The tag of what was received; 0 for nothing.
    int receiveOne(Inbox& inbox) {
        const std::lock_guard lock(m_mpi);
        int isThere = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &isThere, &status);
        if (isThere == 0) {
            return 0;
        }
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        platform::Bytes bytes(static_cast<std::size_t>(size));
        MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        const std::lock_guard inboxLock(inbox.mutex);
        if (status.MPI_TAG == kDoneTag) {
            std::memcpy(&inbox.endings.emplace_back(), bytes.data(), sizeof(Word));
            return kDoneTag;
        }
        std::uint64_t unit = 0;
        bytes.resize(bytes.size() - sizeof unit);
        std::memcpy(&unit, bytes.data() + bytes.size(), sizeof unit);
        inbox.made.emplace_back(unit, std::move(bytes));
        return kMadeTag;
    }

    std::unique_ptr<HeldSignals> m_signals;  ///< until the end of the run
    std::unique_ptr<MpiLifetime> m_lifetime; ///< ends after all below
    Explain m_explain;
    Say m_say;
    std::optional<MpiMachine> m_machine;
    std::optional<RankWatch> m_watch;
    MpiCounters m_counters;
    std::mutex m_mpi;         ///< of the first rank, whose receiver calls MPI too
    std::exception_ptr m_own; ///< what ended the first rank's units
    bool m_isOver = false;    ///< whether all ranks know that one has failed
    int m_status = 0;         ///< that all end with
};

} // namespace

std::unique_ptr<Run> makeMpiRanks(Explain explain, Say say) {
    auto signals = std::make_unique<HeldSignals>(); // before MPI, which may start threads
    auto lifetime = std::make_unique<MpiLifetime>();
    return std::make_unique<MpiRanks>(std::move(signals), std::move(lifetime), std::move(explain),
                                      std::move(say));
}

std::string mpiLibrary() {
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
    int length = 0;
    MPI_Get_library_version(text.data(), &length);
    const std::string whole(text.data(), static_cast<std::size_t>(length));
    return whole.substr(0, whole.find_first_of(",\n"));
}

} // namespace cdr::ranks
