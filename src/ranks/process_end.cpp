#include <ranks/process_end.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>

namespace cdr::ranks {

namespace {

struct Crash {
    int signal;
    const char* name;
};
constexpr std::array kCrashes{Crash{SIGSEGV, "segmentation fault"}, Crash{SIGBUS, "bus error"},
                              Crash{SIGFPE, "arithmetic error"}, Crash{SIGILL, "illegal instruction"},
                              Crash{SIGABRT, "aborted"}};

// A handler may use nothing else. It needs a stack of its own where the other one has overflowed.
std::atomic<LifeLock*> crashesAreNotedIn{nullptr};
std::array<struct sigaction, kCrashes.size()> actionsBefore{};
alignas(16) std::array<std::byte, std::size_t{64} * 1024> stackOfHandler{};

void restoreActions() {
    for (std::size_t i = 0; i < kCrashes.size(); ++i) {
        ::sigaction(kCrashes[i].signal, &actionsBefore[i], nullptr);
    }
}

extern "C" void noteTheCrash(int signal) {
    if (LifeLock* lock = crashesAreNotedIn.exchange(nullptr)) {
        lock->noteCrash(signal);
    }
    restoreActions();
    ::raise(signal); // which is taken when this one returns
}

void giveHandlerItsStack() {
    stack_t stack{};
    ::sigaltstack(nullptr, &stack);
    if ((stack.ss_flags & SS_DISABLE) != 0) {
        stack = {};
        stack.ss_sp = stackOfHandler.data();
        stack.ss_size = stackOfHandler.size();
        ::sigaltstack(&stack, nullptr);
    }
}

sigset_t setOf(const std::vector<int>& signals) {
    sigset_t set;
    ::sigemptyset(&set);
    for (const int signal : signals) {
        ::sigaddset(&set, signal);
    }
    return set;
}

} // namespace

LifeLock::LifeLock() {
    pthread_mutexattr_t attributes;
    ::pthread_mutexattr_init(&attributes);
    ::pthread_mutexattr_setpshared(&attributes, PTHREAD_PROCESS_SHARED);
    ::pthread_mutexattr_setrobust(&attributes, PTHREAD_MUTEX_ROBUST);
    ::pthread_mutex_init(&m_mutex, &attributes);
    ::pthread_mutexattr_destroy(&attributes);
}

void LifeLock::hold() {
    ::pthread_mutex_lock(&m_mutex);
}

void LifeLock::letGo() {
    ::pthread_mutex_unlock(&m_mutex);
}

bool LifeLock::waitForEnd() {
    const bool hasEnded = ::pthread_mutex_lock(&m_mutex) == EOWNERDEAD;
    ::pthread_mutex_unlock(&m_mutex);
    return hasEnded;
}

NotedCrashes::NotedCrashes(LifeLock& lock) {
    crashesAreNotedIn = &lock;
    giveHandlerItsStack();
    struct sigaction action {};
    action.sa_handler = noteTheCrash;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < kCrashes.size(); ++i) {
        ::sigaction(kCrashes[i].signal, &action, &actionsBefore[i]);
    }
}

NotedCrashes::~NotedCrashes() {
    restoreActions();
    crashesAreNotedIn = nullptr;
}

const char* nameOfCrash(int signal) {
    const auto* crash = std::find_if(kCrashes.begin(), kCrashes.end(),
                                     [&](const Crash& each) { return each.signal == signal; });
    return crash != kCrashes.end() ? crash->name : "signal";
}

HeldSignals::HeldSignals() {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler != SIG_IGN) {
            m_numbers.push_back(signal);
        }
    }
    const sigset_t set = setOf(m_numbers);
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

HeldSignals::~HeldSignals() {
    const sigset_t set = setOf(m_numbers);
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

int HeldSignals::wait(std::chrono::milliseconds atMost) const {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(atMost);
    const timespec time{.tv_sec = seconds.count(),
                        .tv_nsec = std::chrono::nanoseconds(atMost - seconds).count()};
    const sigset_t set = setOf(m_numbers);
    const int signal = ::sigtimedwait(&set, nullptr, &time);
    return signal > 0 ? signal : 0;
}

void HeldSignals::wake(std::jthread& waiting) const {
    if (!m_numbers.empty()) {
        ::pthread_kill(waiting.native_handle(), m_numbers.front());
    }
}

const char* nameOfSignal(int signal) {
    return signal == SIGHUP ? "SIGHUP" : signal == SIGINT ? "SIGINT" : "SIGTERM";
}

void endBySignal(int signal) {
    const int number = signal == 0 ? SIGTERM : signal;
    const sigset_t set = setOf({number});
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    ::raise(number);
    ::_exit(1); // where the process ignores it
}

} // namespace cdr::ranks
