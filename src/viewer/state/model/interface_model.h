#pragma once

#include <cdr/base/quantity_text.h>
#include <viewer/state/first_steps.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace cdr::viewer {

/// The panels beside the picture, as their tabs name them.
inline constexpr std::array<const char*, 5> kPanels{"Look", "Camera", "Draw", "Frame", "Inside"};

/// The panel whose controls the keyboard reaches, instead of the camera.
struct PanelKeys {
    std::size_t panel = 0; ///< of kPanels
    bool isOpened = false; ///< whether it has come to the front
};

/// What a notice is about.
enum class NoticeKind : std::uint8_t {
    news,    ///< what was done
    problem, ///< what did not work
    opening, ///< how far a file is opened; it goes once the scene is there
};

/// A line for the person at the window, and until when it shows.
struct Notice {
    std::string text;
    NoticeKind kind = NoticeKind::news;
    std::chrono::steady_clock::time_point until{};

    /// Whether a frame drawn at `last` may show it though it is over now.
    bool isOverSince(std::chrono::steady_clock::time_point last,
                     std::chrono::steady_clock::time_point now) const {
        return last <= until && until < now;
    }
};

/// What stands beside and over the picture.
struct InterfaceModel {
    base::LengthUnit unit = base::LengthUnit::automatic; ///< of lengths
    bool showsPanel = true;
    std::optional<PanelKeys> panelKeys;
    bool showsHelp = false;
    float hiddenHelp = 0.0f; ///< rows of the help that need scrolling, in the window's units
    FirstSteps firstSteps;
    Notice notice;

    void say(std::string text, NoticeKind kind = NoticeKind::news) {
        constexpr std::chrono::seconds kShown{6};
        notice = {.text = std::move(text), .kind = kind, .until = std::chrono::steady_clock::now() + kShown};
    }
    void sayProblem(std::string text) { say(std::move(text), NoticeKind::problem); }
};

} // namespace cdr::viewer
