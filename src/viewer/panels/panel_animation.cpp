#include "panels.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace cdr::viewer {

namespace {

std::string titleOf(const scene::OpenedScene& scene, int number) {
    if (number < 0) {
        return "none: at rest";
    }
    const std::string& name = scene.animations[static_cast<std::size_t>(number)].name;
    return name.empty() ? "animation " + std::to_string(number) : name;
}

void chooseAnimation(const Widgets& widgets, const scene::OpenedScene& scene, scene::GltfChoice& choice,
                     Playback& playback) {
    const int chosen = chosenNumber(choice, scene);
    const std::size_t count = scene.animations.size() + 1;
    std::string title; // that the combo's view refers to
    const std::size_t picked =
        widgets.combo("plays", titleOf(scene, chosen), count, [&](std::size_t i) -> std::string_view {
            title = titleOf(scene, static_cast<int>(i) - 1);
            return title;
        });
    if (picked < count && static_cast<int>(picked) - 1 != chosen) {
        choice = withAnimation(choice, scene, static_cast<int>(picked) - 1);
        playback.seconds = 0.0;
        playback.isPlaying = picked > 0;
    }
}

} // namespace

void drawAnimationPanel(const Widgets& widgets, const RenderResult* result, ViewSettings& settings,
                        Playback& playback) {
    if (result == nullptr || result->scene->animations.empty() || result->sceneName != settings.scene) {
        return;
    }
    constexpr double kSlowest = 0.1;
    constexpr double kFastest = 10.0;
    const scene::OpenedScene& scene = *result->scene;
    widgets.heading("Animation");
    chooseAnimation(widgets, scene, settings.choice, playback);
    const double length = playableSeconds(settings.choice, scene);
    if (length <= 0.0) {
        return;
    }
    if (widgets.toggle(playback.isPlaying ? "pause" : "play animation", onIf(playback.isPlaying))) {
        playback.toggle(length);
    }
    widgets.beside();
    widgets.checkbox("loop", playback.loops);
    const double start = settings.choice.seconds.value_or(0.0);
    double moment = playback.moment(settings.choice);
    if (widgets.slider("time", moment, {.low = start, .high = start + length, .format = "%.3f s"})) {
        playback.goTo(moment, settings.choice);
        playback.isPlaying = false;
    }
    widgets.slider("speed", playback.speed,
                   {.low = kSlowest, .high = kFastest, .format = "%.2f times", .isLogarithmic = true});
}

} // namespace cdr::viewer
