// Runs a fuzzer without libFuzzer, over the files that it is given and those of the folders that it is given. Then it runs it
// over files that are made from these by random cuts, splices and changes. The same seed makes the same files. CDR_FUZZ_CASES is
// their number. Without it they are 25,000, or 100,000 with CDR_ALL_CASES.

#include "../support/all_cases.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;
constexpr std::size_t kMaxBytes = 4096; // larger seeds are run, but nothing is made of them

/// std::filesystem::filesystem_error for a folder that cannot be read.
std::vector<std::filesystem::path> seedFiles(int count, char** paths) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < count; ++i) {
        if (!std::filesystem::is_directory(paths[i])) {
            files.emplace_back(paths[i]);
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(paths[i])) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// std::runtime_error for a file or folder that cannot be read.
std::vector<Input> readSeeds(int count, char** paths) {
    std::vector<Input> seeds;
    for (const auto& file : seedFiles(count, paths)) {
        std::ifstream stream(file, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
        if (!stream) {
            throw std::runtime_error(file.string() + ": cannot be read");
        }
    }
    return seeds;
}

class Mutator {
  public:
    explicit Mutator(const std::vector<Input>& seeds) : m_seeds(seeds) {}

    Input next() {
        Input input = m_seeds[below(m_seeds.size())];
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
            change(input);
        }
        return input;
    }

  private:
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_random() % count); }
    auto place(const Input& input) { return static_cast<std::ptrdiff_t>(below(input.size() + 1)); }
    void change(Input& input) {
        const Input& other = m_seeds[below(m_seeds.size())];
        const std::ptrdiff_t at = place(input);
        switch (below(5)) {
        case 0: // cut
            input.resize(static_cast<std::size_t>(at));
            break;
        case 1: // a part of another
            input.insert(input.begin() + at, other.begin() + place(other) / 2, other.end());
            break;
        case 2: // a digit, where numbers are texts
            input.insert(input.begin() + at, static_cast<std::uint8_t>("0123456789-.eEn,:[]{}"[below(21)]));
            break;
        case 3: // lost
            input.erase(input.begin() + at,
                        input.begin() + std::min<std::ptrdiff_t>(at + static_cast<std::ptrdiff_t>(below(8)),
                                                                 static_cast<std::ptrdiff_t>(input.size())));
            break;
        default:
            if (!input.empty()) {
                input[below(input.size())] = static_cast<std::uint8_t>(m_random());
            }
        }
        input.resize(std::min(input.size(), kMaxBytes));
    }

    const std::vector<Input>& m_seeds;
    std::mt19937_64 m_random{2013};
};

} // namespace

int main(int argc, char** argv) {
    std::vector<Input> seeds;
    try {
        seeds = readSeeds(argc, argv);
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    for (const Input& seed : seeds) {
        LLVMFuzzerTestOneInput(seed.data(), seed.size());
    }
    std::erase_if(seeds, [](const Input& seed) { return seed.size() > kMaxBytes; });
    if (seeds.empty()) {
        std::fputs("no seeds\n", stderr);
        return 1;
    }
    const char* asked = std::getenv("CDR_FUZZ_CASES");
    const long cases = asked != nullptr ? std::atol(asked) : cdr::test::takesAllCases() ? 100'000 : 25'000;
    Mutator mutator(seeds);
    for (long i = 0; i < cases; ++i) {
        const Input input = mutator.next();
        LLVMFuzzerTestOneInput(input.data(), input.size());
    }
    std::printf("%zu seeds, %ld cases made of them\n", seeds.size(), cases);
    return 0;
}
