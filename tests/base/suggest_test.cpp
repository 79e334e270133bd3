#include <cdr/base/suggest.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::base {

namespace {

/// Levenshtein distance by its definition: every entry of the table.
std::size_t plainDistance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                table[i][j] = i + j;
                continue;
            }
            table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                                    table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
        }
    }
    return table[a.size()][b.size()];
}

/// The message as it is defined: the first name of the least distance, where that is at most one and half the name.
std::string plainMessage(std::string_view given, std::span<const std::string_view> known) {
    const std::string shown(given.substr(0, 60));
    std::string list;
    std::string hint;
    std::size_t least = std::string::npos;
    for (const std::string_view name : known) {
        list += (list.empty() ? "" : ", ") + std::string(name);
        const std::size_t distance = plainDistance(shown, name);
        if (distance < least) {
            least = distance;
            hint = distance <= 1 + name.size() / 2 ? "; did you mean '" + std::string(name) + "'?"
                                                   : std::string();
        }
    }
    return "unknown word '" + shown + "'" + hint + " (known: " + list + ")";
}

/// Every quoted word of the sources: all names of options and of their values are among them.
std::vector<std::string> quotedWords() {
    const auto mayBe = [](unsigned char c) {
        return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-';
    };
    std::set<std::string> words;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(CDR_SOURCES)) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") {
            continue;
        }
        std::ifstream stream(entry.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (std::size_t begin = text.find('"'); begin != std::string::npos;
             begin = text.find('"', begin + 1)) {
            const auto end =
                std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(begin) + 1, text.end(), mayBe);
            const std::string word(text.begin() + static_cast<std::ptrdiff_t>(begin) + 1, end);
            if (!word.empty() && end != text.end() && *end == '"') {
                words.insert(word);
            }
        }
    }
    return {words.begin(), words.end()};
}

class Typist {
  public:
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_random() % count); }

    std::string word(std::size_t longest, std::string_view letters) {
        std::string word(below(longest + 1), ' ');
        std::generate(word.begin(), word.end(), [&] { return letters[below(letters.size())]; });
        return word;
    }

    /// With some characters lost, added or exchanged.
    std::string mistyped(std::string word) {
        for (std::size_t slips = below(7); slips > 0; --slips) {
            const std::size_t at = below(word.size() + 1);
            word.replace(at, below(2), this->word(1, "abcdefghijklmnopqrstuvwxyz-"));
        }
        return word;
    }

  private:
    std::mt19937_64 m_random{2013};
};

TEST(UnknownName, SuggestsTheClosest) {
    constexpr std::array<std::string_view, 3> kKnown{"standard", "reversed", "log"};
    EXPECT_NE(unknownName("technique", "reversd", kKnown).find("did you mean 'reversed'"), std::string::npos);
    EXPECT_EQ(unknownName("technique", "zzzzzzzzzzzzz", kKnown).find("did you mean"), std::string::npos);
    EXPECT_LT(unknownName("technique", std::string(100000, 'x'), kKnown).size(), 200u);
    EXPECT_EQ(unknownName("technique", "log", {}), "unknown technique 'log' (known: )");
}

TEST(UnknownName, SaysOfTheProgramsNamesWhatItsDefinitionSays) {
    const std::vector<std::string> words = quotedWords();
    ASSERT_GT(words.size(), 500u);
    ASSERT_TRUE(std::binary_search(words.begin(), words.end(), "anchored"));
    Typist typist;
    std::size_t hints = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::string_view> known(1 + typist.below(12));
        std::generate(known.begin(), known.end(),
                      [&]() -> std::string_view { return words[typist.below(words.size())]; });
        const std::string given = typist.mistyped(std::string(known[typist.below(known.size())]));
        const std::string said = unknownName("word", given, known);
        ASSERT_EQ(said, plainMessage(given, known));
        hints += said.find("did you mean") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(hints, 1500u);
    EXPECT_LT(hints, 3000u);
}

TEST(UnknownName, SaysOfRandomWordsWhatItsDefinitionSays) {
    // Two letters, so that many names are equally close; longer than what is shown, too.
    Typist typist;
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::string> names(typist.below(6));
        std::generate(names.begin(), names.end(),
                      [&] { return typist.word(round % 10 == 0 ? 90 : 12, "ab"); });
        const std::vector<std::string_view> known(names.begin(), names.end());
        const std::string given = typist.word(round % 10 == 0 ? 90 : 12, "ab");
        ASSERT_EQ(unknownName("word", given, known), plainMessage(given, known));
    }
}

} // namespace

} // namespace cdr::base
