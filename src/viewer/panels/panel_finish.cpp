#include "choice.h"
#include "panels.h"

#include <cdr/base/quantity_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace cdr::viewer {

namespace {

/// Scene units, for a radius or a visibility; 0 for none.
constexpr std::array kLengths{0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6};
constexpr std::array<std::string_view, kLengths.size()> kLengthNames{
    "none", "0.1", "0.3", "1", "3", "10", "100", "1,000", "10,000", "100,000", "1,000,000"};

std::string nameOfLength(double length) {
    const auto* const found = std::find(kLengths.begin(), kLengths.end(), length);
    return found == kLengths.end()
               ? base::quantityText(length)
               : std::string(kLengthNames[static_cast<std::size_t>(found - kLengths.begin())]);
}

void chooseLength(const Widgets& widgets, std::string_view name, double& length) {
    const std::size_t chosen = widgets.combo(name, nameOfLength(length), kLengths.size(),
                                             [](std::size_t i) { return kLengthNames[i]; });
    if (chosen < kLengths.size()) {
        length = kLengths[chosen];
    }
}

} // namespace

void drawFinishPanel(const Widgets& widgets, ViewSettings& settings) {
    widgets.heading("Finish");
    Finish& finish = settings.finish;
    choose(widgets, "detail", visibility::kDetailModes, finish.detail.mode);
    choose(widgets, "translucency", render::kTranslucencies, finish.translucency.method);
    choose(widgets, "shadows", render::kShadowMethods, finish.shadows.method);
    if (finish.shadows.isOn() && !castsShadows(finish, settings.targets.kind)) {
        widgets.sentence("So no shadows are drawn now.");
    }
    choose(widgets, "edges", render::kAntialiases, finish.effects.antialias);
    choose(widgets, "tone mapping", render::kToneMaps, finish.effects.finish.toneMap);
    chooseLength(widgets, "occlusion", finish.effects.occlusion.radius);
    if (hasLayers(settings.targets.kind)) {
        widgets.checkbox("on each cascade alone", finish.effects.occlusion.perLayer);
    }
    widgets.sentence(explanationOf(finish.effects.occlusion));
    chooseLength(widgets, "fog", finish.effects.fog.visibility);
    widgets.sentence(explanationOf(finish.effects.fog));
    if (settings.targets.kind == render::TargetsKind::layers) {
        chooseLength(widgets, "focus", finish.focus.distance);
        chooseLength(widgets, "aperture", finish.focus.aperture);
        widgets.checkbox("fade between cascades", finish.focus.blend);
    }
    widgets.sentence(explanationOf(finish.focus));
}

} // namespace cdr::viewer
