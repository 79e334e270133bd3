#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <experiments/flicker/state.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace cdr::experiments {

namespace {

using StateJson = nlohmann::ordered_json;

const FlickerRun kStateRun{.digest = "run", .frames = 4, .pixels = 100};

FlickerState freshState() {
    FlickerState state;
    for (const char* technique : {"log", "anchored"}) {
        state.results.emplace_back().technique = technique;
    }
    return state;
}

/// After two frames, with counts that differ between the techniques.
std::string stateText() {
    FlickerState state = freshState();
    state.framesDone = 2;
    for (std::size_t i = 0; i < state.results.size(); ++i) {
        FlickerResult& result = state.results[i];
        result.wrong = {.pixels = 150, .wrong = 3 + i};
        result.flips = {.flips = 2, .compared = 90};
        result.flipSum = 0.1 + 0.2;
        result.flipFrames = 2;
        result.duplicationSum = 2.3;
        result.cascades = 1 + i;
    }
    return stateTextOf(kStateRun, state);
}

FlickerState readBack(const std::string& text) {
    return readState(text, kStateRun, freshState(), "s.json");
}

/// What a state is refused with, whose text was changed so; empty where it is taken.
std::string stateRefusal(const std::function<void(StateJson&)>& change) {
    StateJson json = StateJson::parse(stateText());
    change(json);
    try {
        readBack(json.dump());
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(FlickerState, IsReadAsItWasWritten) {
    const FlickerState state = readBack(stateText());
    EXPECT_EQ(state.framesDone, 2u);
    ASSERT_EQ(state.results.size(), 2u);
    EXPECT_EQ(state.results[1].technique, "anchored");
    EXPECT_EQ(state.results[1].wrong.wrong, 4u);
    EXPECT_EQ(state.results[1].flipSum, 0.1 + 0.2);
    EXPECT_EQ(stateTextOf(kStateRun, state), stateText());
    EXPECT_EQ(stateRefusal([](StateJson&) {}), ""); // also with other spaces
}

/// Each is possible in the run, and only the sum tells.
TEST(FlickerState, AChangedNumberIsDamage) {
    const std::string damaged = "s.json: is damaged; remove it or name another file";
    EXPECT_EQ(stateRefusal([](StateJson& json) { json["frames_done"] = 3; }), damaged);
    EXPECT_EQ(stateRefusal([](StateJson& json) { json["sha256"] = std::string(64, '0'); }), damaged);
    const StateJson whole = StateJson::parse(stateText());
    for (const auto& [name, value] : whole.at("results").at(0).items()) {
        if (name == "technique") {
            continue;
        }
        StateJson changed;
        if (value.is_number_float()) {
            changed = value.get<double>() * 0.5;
        } else {
            const auto count = value.get<std::uint64_t>();
            changed = count == 0 ? 1 : count - 1;
        }
        const bool isOverlap = name == "overlap_wrong"; // of which there can be no more than pixels
        const std::string& field = name;                // clang 14 captures no structured bindings
        const std::string refusal =
            stateRefusal([&](StateJson& json) { json["results"][0][field] = changed; });
        EXPECT_TRUE(isOverlap ? !refusal.empty() : refusal == damaged) << name << ": " << refusal;
    }
}

TEST(FlickerState, ResultsOfOtherTechniquesAreRefused) {
    const std::string refusal =
        "s.json: holds results of other techniques than the run has; remove it or name another file";
    EXPECT_EQ(stateRefusal([](StateJson& json) { std::swap(json["results"][0], json["results"][1]); }),
              refusal);
    EXPECT_EQ(stateRefusal([](StateJson& json) { json["results"].push_back(json["results"][1]); }), refusal);
    EXPECT_EQ(stateRefusal([](StateJson& json) { json["results"].erase(1); }), refusal);
    EXPECT_EQ(stateRefusal([](StateJson& json) { json["results"][1]["technique"] = "cdr"; }), refusal);
}

/// As builds before 1.0.0 wrote it.
TEST(FlickerState, AStateWithoutASumIsDamaged) {
    EXPECT_EQ(stateRefusal([](StateJson& json) { json.erase("sha256"); }),
              "s.json: is damaged; remove it or name another file");
}

/// As a driver may name its device.
TEST(FlickerState, IsKeptForADeviceWhoseNameIsNotUtf8) {
    const test::TemporaryFolder folder;
    gpu::DeviceInfo device;
    device.name = "\xff";
    const FlickerStateFile file(folder.path() / "s.json", FlickerOptions{}, device);
    FlickerState state = freshState();
    state.framesDone = 2;
    file.save(state);
    FlickerState kept = freshState();
    file.load(kept);
    EXPECT_EQ(kept.framesDone, 2u);
}

} // namespace

} // namespace cdr::experiments
