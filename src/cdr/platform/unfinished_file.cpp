#include <cdr/platform/unfinished_file.h>

#include <climits>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <system_error>

namespace cdr::platform {

namespace {

enum class SlotState { free, changing, taken };

/// A signal handler may neither lock nor allocate. So names are in fixed memory, and one atomic word says who owns a slot.
struct Slot {
    std::atomic<SlotState> state{SlotState::free};
    std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<SlotState>::is_always_lock_free);

constexpr std::size_t kSlots = 64;
std::array<Slot, kSlots> slots;

bool claim(Slot& slot, SlotState from) {
    return slot.state.compare_exchange_strong(from, SlotState::changing);
}

extern "C" void removeUnfinishedFiles(int signal) {
    for (Slot& slot : slots) {
        if (claim(slot, SlotState::taken)) {
            ::unlink(slot.path.data());
        }
    }
    ::raise(signal); // its default action is in force again, see SA_RESETHAND
}

} // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) : m_slot(kSlots) {
    std::error_code error;
    const std::string whole = std::filesystem::absolute(path, error).string();
    if (error || whole.size() >= PATH_MAX) {
        return;
    }
    for (std::size_t i = 0; i < kSlots; ++i) {
        if (claim(slots[i], SlotState::free)) {
            whole.copy(slots[i].path.data(), whole.size());
            slots[i].path[whole.size()] = '\0';
            slots[i].state = SlotState::taken;
            m_slot = i;
            return;
        }
    }
}

UnfinishedFile::~UnfinishedFile() {
    if (m_slot < kSlots && claim(slots[m_slot], SlotState::taken)) {
        slots[m_slot].state = SlotState::free;
    }
}

void removeUnfinishedFilesOnSignals() {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU}) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_DFL) {
            action = {};
            action.sa_handler = removeUnfinishedFiles;
            action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
            ::sigaction(signal, &action, nullptr);
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace cdr::platform
