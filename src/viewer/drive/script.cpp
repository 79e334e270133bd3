#include "script.h"

#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/platform/file.h>
#include <viewer/window/window.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <string_view>

namespace cdr::viewer {

namespace {

constexpr double kMaxCount = 1e6;
constexpr std::uintmax_t kMaxScriptBytes = 1 << 20;

int keyOf(const std::string& name) {
    static const std::map<std::string, int, std::less<>> kNamed{
        {"tab", GLFW_KEY_TAB},          {"space", GLFW_KEY_SPACE},
        {"home", GLFW_KEY_HOME},        {"up", GLFW_KEY_UP},
        {"down", GLFW_KEY_DOWN},        {"left", GLFW_KEY_LEFT},
        {"right", GLFW_KEY_RIGHT},      {"escape", GLFW_KEY_ESCAPE},
        {"shift", GLFW_KEY_LEFT_SHIFT}, {"control", GLFW_KEY_LEFT_CONTROL},
        {"alt", GLFW_KEY_LEFT_ALT},     {"enter", GLFW_KEY_ENTER}};
    if (const auto found = kNamed.find(name); found != kNamed.end()) {
        return found->second;
    }
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0) {
        return std::toupper(static_cast<unsigned char>(name[0])); // GLFW's codes are those of ASCII
    }
    for (int i = 1; i <= 12; ++i) {
        if (name == fmt::format("F{}", i)) {
            return GLFW_KEY_F1 + i - 1;
        }
    }
    throw base::inputError("no key '{}'", name.substr(0, 20));
}

/// The words of one line, taken in turn.
class Words {
  public:
    explicit Words(const std::string& line) : m_words(line) {}

    std::string next(const char* what) {
        std::string word;
        if (!(m_words >> word)) {
            throw base::inputError("{} missing", what);
        }
        return word;
    }
    std::string nextOr(std::string otherwise) {
        std::string word;
        return m_words >> word ? word : std::move(otherwise);
    }
    double number(const char* what) { return base::parseNumber(what, next(what)); }
    int whole(const char* what, int low, int high) { return wholeOf(what, next(what), low, high); }
    static int wholeOf(const char* what, const std::string& word, int low, int high) {
        const double value = base::parseNumber(what, word);
        if (value < low || value > high || value != static_cast<double>(static_cast<int>(value))) {
            throw base::inputError("{} must be {} to {}", what, low, high);
        }
        return static_cast<int>(value);
    }
    /// All that is left, spaces included.
    std::string rest(const char* what) {
        std::string words;
        std::getline(m_words >> std::ws, words);
        if (words.empty()) {
            throw base::inputError("{} missing", what);
        }
        return words;
    }
    void requireEnd() {
        if (const std::string word = nextOr(""); !word.empty()) {
            throw base::inputError("'{}' is one word too many", word.substr(0, 20));
        }
    }

  private:
    std::istringstream m_words;
};

using Steps = std::vector<ScriptStep>;
using Reader = std::function<void(Words&, Steps&)>;

void readKey(Words& words, Steps& steps) {
    static constexpr std::array<std::string_view, 2> kModifiers{"shift", "control"};
    const int key = keyOf(words.next("key"));
    int modifiers = 0;
    for (std::string word = words.nextOr(""); !word.empty(); word = words.nextOr("")) {
        if (word != kModifiers[0] && word != kModifiers[1]) {
            throw base::InputError(base::unknownName("modifier", word, kModifiers));
        }
        modifiers |= word == kModifiers[0] ? GLFW_MOD_SHIFT : GLFW_MOD_CONTROL;
    }
    steps.emplace_back(InputEvent(KeyInput{.key = key, .pressed = true, .modifiers = modifiers}));
    steps.emplace_back(InputEvent(KeyInput{.key = key, .pressed = false, .modifiers = modifiers}));
}

/// What a key or a button does.
enum class Push : std::uint8_t { down, up };

void readHeld(Words& words, Steps& steps, Push push) {
    steps.emplace_back(InputEvent(KeyInput{.key = keyOf(words.next("key")), .pressed = push == Push::down}));
}

void readButton(Words& words, Steps& steps, Push push) {
    const int button = Words::wholeOf("button", words.nextOr("0"), 0, 4);
    steps.emplace_back(InputEvent(ButtonInput{.button = button, .pressed = push == Push::down}));
}

const std::map<std::string, Reader, std::less<>>& readers() {
    static const std::map<std::string, Reader, std::less<>> kReaders{
        {"key", readKey},
        {"hold", [](Words& w, Steps& s) { readHeld(w, s, Push::down); }},
        {"let", [](Words& w, Steps& s) { readHeld(w, s, Push::up); }},
        {"press", [](Words& w, Steps& s) { readButton(w, s, Push::down); }},
        {"release", [](Words& w, Steps& s) { readButton(w, s, Push::up); }},
        {"move",
         [](Words& w, Steps& s) {
             const double x = w.number("x");
             s.emplace_back(InputEvent(MoveInput{x, w.number("y")}));
         }},
        {"scroll",
         [](Words& w, Steps& s) {
             s.emplace_back(InputEvent(ScrollInput{0.0, w.number("notches")}));
         }},
        {"click", [](Words& w, Steps& s) { s.emplace_back(ClickItem{w.rest("item")}); }},
        {"type",
         [](Words& w, Steps& s) {
             for (const char letter : w.rest("text")) {
                 s.emplace_back(InputEvent(CharacterInput{.codepoint = static_cast<unsigned char>(letter)}));
             }
         }},
        {"drop", [](Words& w, Steps& s) { s.emplace_back(InputEvent(DropInput{{w.rest("file")}})); }},
        {"drop-all",
         [](Words& w, Steps& s) {
             DropInput drop;
             for (std::string file = w.next("file"); !file.empty(); file = w.nextOr("")) {
                 drop.paths.emplace_back(file);
             }
             s.emplace_back(InputEvent(std::move(drop)));
         }},
        {"resize",
         [](Words& w, Steps& s) {
             const int width = w.whole("width", 1, kMaxWindowSide);
             s.emplace_back(WindowSize{width, w.whole("height", 1, kMaxWindowSide)});
         }},
        {"minimise", [](Words&, Steps& s) { s.emplace_back(Minimise{}); }},
        {"restore", [](Words&, Steps& s) { s.emplace_back(Restore{}); }},
        {"wait-frame",
         [](Words& w, Steps& s) {
             s.emplace_back(WaitFrame{static_cast<std::uint64_t>(
                 Words::wholeOf("frames", w.nextOr("0"), 0, static_cast<int>(kMaxCount)))});
         }},
        {"wait-ui",
         [](Words& w, Steps& s) {
             s.emplace_back(
                 WaitUi{static_cast<std::uint64_t>(w.whole("frames", 1, static_cast<int>(kMaxCount)))});
         }},
        {"window", [](Words& w, Steps& s) { s.emplace_back(SaveWindow{w.rest("file")}); }},
        {"picture", [](Words& w, Steps& s) { s.emplace_back(SavePicture{w.rest("file")}); }},
        {"where", [](Words& w, Steps& s) { s.emplace_back(PrintPlace{w.rest("item")}); }},
        {"state", [](Words&, Steps& s) { s.emplace_back(PrintState{}); }},
        {"command", [](Words&, Steps& s) { s.emplace_back(PrintCommand{}); }},
        {"wait-state", [](Words& w, Steps& s) { s.emplace_back(WaitState{w.rest("text")}); }},
        {"quit", [](Words&, Steps& s) { s.emplace_back(Quit{}); }},
    };
    return kReaders;
}

void readLine(const std::string& line, Steps& steps) {
    Words words(line);
    const std::string verb = words.nextOr("#");
    if (verb.front() == '#') {
        return;
    }
    const auto reader = readers().find(verb);
    if (reader == readers().end()) {
        std::vector<std::string_view> known;
        for (const auto& [name, read] : readers()) {
            known.push_back(name);
        }
        throw base::InputError(base::unknownName("step", verb, known));
    }
    reader->second(words, steps);
    words.requireEnd();
}

} // namespace

std::vector<ScriptStep> parseScript(const std::string& text, const std::string& name) {
    std::vector<ScriptStep> steps;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        try {
            readLine(line, steps);
        } catch (const base::InputError& error) {
            throw base::inputError("{}, line {}: {}", name, number, error.what());
        }
    }
    return steps;
}

std::vector<ScriptStep> readScript(const std::filesystem::path& file) {
    const platform::Bytes bytes = platform::readFile(file, kMaxScriptBytes);
    return parseScript({bytes.begin(), bytes.end()}, file.string());
}

} // namespace cdr::viewer
