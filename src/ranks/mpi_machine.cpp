#include <cdr/platform/thread_placement.h>

#include <ranks/mpi_machine.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace cdr::ranks {

namespace {

/// As many as sched_getaffinity() has numbers for; without an answer it gives none.
constexpr std::size_t kMaxCpus = 1024;

/// In the memory that ranks share, behind SharedLife.
constexpr std::size_t kLocksAt = 64;
static_assert(sizeof(SharedLife) <= kLocksAt && kLocksAt % alignof(LifeLock) == 0);

constexpr std::size_t bytesShared(std::size_t ranks) {
    return kLocksAt + ranks * sizeof(LifeLock);
}

std::string machineName() {
    std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
    int length = 0;
    MPI_Get_processor_name(name.data(), &length);
    return {name.data(), static_cast<std::size_t>(length)};
}

/// The ranks of this rank's machine, to be freed.
MPI_Comm splitByMachine() {
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    return machine;
}

std::pair<std::size_t, std::size_t> indexAndCount(MPI_Comm ranks) {
    int index = 0;
    int count = 1;
    MPI_Comm_rank(ranks, &index);
    MPI_Comm_size(ranks, &count);
    return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
}

/// What each rank tells of itself, by rank.
template <typename Value>
std::vector<Value> gathered(MPI_Comm ranks, std::size_t count, const Value& mine) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::vector<Value> all(count);
    MPI_Allgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, ranks);
    return all;
}

} // namespace

Place placeAmongAll() {
    MPI_Comm machine = splitByMachine();
    const auto [index, count] = indexAndCount(MPI_COMM_WORLD);
    const auto [indexOnNode, countOnNode] = indexAndCount(machine);
    MPI_Comm_free(&machine);
    return {.index = index,
            .count = count,
            .indexOnNode = indexOnNode,
            .countOnNode = countOnNode,
            .node = machineName()};
}

MpiMachine::MpiMachine() : m_ranks(splitByMachine()) {
    const auto [index, count] = indexAndCount(m_ranks);
    m_count = count;
    void* memory = nullptr;
    MPI_Win_allocate_shared(index == 0 ? static_cast<MPI_Aint>(bytesShared(count)) : 0, 1, MPI_INFO_NULL,
                            m_ranks, &memory, &m_memory);
    MPI_Aint size = 0;
    int unit = 0;
    MPI_Win_shared_query(m_memory, 0, &size, &unit, &memory); // where this rank sees what the first allocated
    m_life = static_cast<SharedLife*>(memory);
    m_locks = reinterpret_cast<LifeLock*>(static_cast<std::byte*>(memory) + kLocksAt);
    if (index == 0) {
        std::construct_at(m_life);
        std::uninitialized_default_construct_n(m_locks, count);
    }
    MPI_Barrier(m_ranks);
    m_locks[index].hold();
    MPI_Barrier(m_ranks);
}

MpiMachine::~MpiMachine() {
    MPI_Win_free(&m_memory);
    MPI_Comm_free(&m_ranks);
}

std::vector<Cpus> MpiMachine::cpusOfRanks() const {
    std::bitset<kMaxCpus> mine;
    for (const std::size_t cpu : platform::allowedCpus()) {
        mine.set(cpu);
    }
    const auto all = gathered(m_ranks, m_count, mine);
    std::vector<Cpus> cpus(m_count);
    for (std::size_t rank = 0; rank < m_count; ++rank) {
        for (std::size_t cpu = 0; cpu < kMaxCpus; ++cpu) {
            if (all[rank].test(cpu)) {
                cpus[rank].push_back(cpu);
            }
        }
    }
    return cpus;
}

std::vector<std::size_t> MpiMachine::numbersOfRanks() const {
    return gathered(m_ranks, m_count, indexAndCount(MPI_COMM_WORLD).first);
}

} // namespace cdr::ranks
