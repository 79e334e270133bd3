// Makes units on all ranks; the first one prints them. Words say what goes wrong, and where.

#include <cdr/base/error.h>

#include <fcntl.h>
#include <ranks/join.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using cdr::ranks::Ending;
using cdr::ranks::Run;

Ending endingOf(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const cdr::base::InputError& bad) {
        return {.status = 2, .line = bad.what()};
    } catch (const std::exception& other) {
        return {.status = 1, .line = other.what()};
    }
}

struct Trouble {
    std::string kind = "none";
    std::size_t rank = 0;
    std::size_t unit = 0;
    std::string file{}; ///< to which each rank adds a byte for each unit that it begins
};

/// Of all sizes, up to far more than one message holds at once.
std::string textOf(std::size_t unit) {
    return "unit " + std::to_string(unit) + " " + std::string(unit % 7 == 3 ? 300'000 : unit, 'x');
}

/// Uses up the stack.
std::size_t descend(std::size_t depth) {
    volatile char used[4096]{}; // which no compiler leaves out
    used[depth % sizeof used] = 1;
    return depth == 0 ? 0 : descend(depth + 1) + static_cast<std::size_t>(used[0]);
}

void crash(const std::string& how) {
    if (how == "segv") { // an address that no sanitizer knows
        void* page = ::mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        *static_cast<volatile char*>(page) = 1;
    } else if (how == "overflow") {
        descend(1);
    } else if (how == "terminate") {
        std::terminate();
    }
    const std::map<std::string, int> signals{{"bus", SIGBUS}, {"fpe", SIGFPE}, {"ill", SIGILL}};
    if (signals.contains(how)) {
        ::kill(::getpid(), signals.at(how));
    }
}

/// The rank that makes the first unit takes a second, and says how many others were begun meanwhile.
void tarry(const Trouble& trouble, std::size_t unit) {
    const int file = ::open(trouble.file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    if (file < 0 || ::write(file, "u", 1) != 1) {
        throw std::runtime_error(trouble.file + ": cannot be written");
    }
    ::close(file);
    if (unit == 0) {
        const std::uintmax_t before = std::filesystem::file_size(trouble.file);
        std::this_thread::sleep_for(std::chrono::seconds(1));
        std::printf("meanwhile %ju\n", std::filesystem::file_size(trouble.file) - before);
    }
}

void makeTrouble(const Run& ranks, const Trouble& trouble, std::size_t unit, int pidOfFirst) {
    if (trouble.kind == "tarry") {
        tarry(trouble, unit);
    }
    if (ranks.place().index != trouble.rank || unit < trouble.unit) {
        return;
    }
    if (trouble.kind == "input") {
        throw cdr::base::InputError("no such thing");
    }
    if (trouble.kind == "run") {
        throw std::runtime_error("it broke");
    }
    if (trouble.kind == "both") { // as a launcher does that has seen a rank go, before another rank has
        ::kill(pidOfFirst, SIGTERM);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (trouble.kind == "die" || trouble.kind == "both") {
        std::raise(SIGKILL);
    }
    crash(trouble.kind);
    const std::map<std::string, int> signals{
        {"HUP", SIGHUP}, {"INT", SIGINT}, {"TERM", SIGTERM}, {"ignore", SIGHUP}};
    if (signals.contains(trouble.kind)) {
        ::kill(::getpid(), signals.at(trouble.kind));
    }
}

void run(Run& ranks, std::size_t count, const Trouble& trouble) {
    const bool isTheOne = ranks.place().index == trouble.rank;
    if (trouble.kind == "start" && isTheOne) {
        throw cdr::base::InputError("cannot start");
    }
    ranks.requireSame(trouble.kind == "differ" && isTheOne ? "otherwise" : "alike", "is not alike");
    ranks.learnMachine();
    ranks.sayWhenKilled("; nothing is kept");
    const cdr::ranks::Place& place = ranks.place();
    if (place.node &&
        (place.cpus.parts.size() != place.countOnNode || place.cpus.parts[place.indexOnNode].empty())) {
        throw std::runtime_error("no CPUs were divided");
    }
    if (trouble.kind == "before" && isTheOne) {
        throw cdr::base::InputError("cannot begin");
    }
    const std::string shared = "from rank " + std::to_string(ranks.place().index);
    const std::string pid = std::to_string(::getpid());
    const cdr::platform::Bytes pidOfFirst = ranks.share({pid.begin(), pid.end()});
    const cdr::platform::Bytes from = ranks.share({shared.begin(), shared.end()});
    std::map<std::string, std::size_t> made;
    std::string merged = std::to_string(ranks.place().index) + " " + textOf(3);
    ranks.merge(
        [&] {
            if (trouble.kind == "pack" && isTheOne) {
                throw std::runtime_error("it broke");
            }
            return cdr::platform::Bytes(merged.begin(), merged.end());
        },
        [&](const cdr::platform::Bytes& later) {
            if (trouble.kind == "lay" && isTheOne) {
                throw cdr::base::InputError("no such thing");
            }
            merged.append(", ").append(later.begin(), later.end());
        });
    if (ranks.isFirst()) {
        std::string whole = "0 " + textOf(3);
        for (std::size_t rank = 1; rank < ranks.place().count; ++rank) {
            whole += ", " + std::to_string(rank) + " " + textOf(3);
        }
        std::printf("merged %s\n", merged == whole ? "whole" : "DAMAGED");
    }
    for (int round = 0; round < 2; ++round) {
        ranks.forEachUnit(
            count,
            [&](std::size_t unit) {
                makeTrouble(ranks, trouble, unit,
                            std::stoi(std::string(pidOfFirst.begin(), pidOfFirst.end())));
                std::this_thread::sleep_for(std::chrono::milliseconds(unit % 3)); // so that all get some
                const std::string text = textOf(unit);
                return cdr::platform::Bytes(text.begin(), text.end());
            },
            [&](std::size_t unit, const cdr::platform::Bytes& bytes) {
                if (trouble.kind == "take" && unit == trouble.unit) {
                    throw std::runtime_error("the disk is full");
                }
                const std::string text(bytes.begin(), bytes.end());
                std::printf("%zu %zu %s\n", unit, text.size(), text == textOf(unit) ? "whole" : "DAMAGED");
            });
    }
    if (ranks.isFirst() || std::string(from.begin(), from.end()) != "from rank 0") {
        std::printf("shared %s\n", std::string(from.begin(), from.end()).c_str());
    }
    if (trouble.kind == "after" && isTheOne) {
        throw std::runtime_error("cannot end");
    }
}

} // namespace

/// rank_program COUNT [KIND RANK UNIT [FILE]]
int main(int argc, char** argv) {
    const Trouble trouble =
        argc > 4 ? Trouble{argv[2], std::stoul(argv[3]), std::stoul(argv[4]), argc > 5 ? argv[5] : ""}
                 : Trouble{};
    if (trouble.kind == "ignore") {
        std::signal(SIGHUP, SIG_IGN);
    }
    const std::unique_ptr<Run> ranks = cdr::ranks::join(
        endingOf, [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); });
    Ending mine;
    try {
        run(*ranks, std::stoul(argv[1]), trouble);
    } catch (...) {
        mine = endingOf(std::current_exception());
    }
    const Ending ending = ranks->end(mine);
    if (!ending.line.empty()) {
        std::fprintf(stderr, "%s\n", ending.line.c_str());
    }
    return ending.status;
}
