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
    render::RenderOptions& drawing = settings.drawing;
    choose(widgets, "detail", visibility::kDetailModes, drawing.detail.mode);
    choose(widgets, "translucency", render::kTranslucencies, drawing.translucency.method);
    choose(widgets, "shadows", render::kShadowMethods, drawing.shadows.method);
    if (drawing.shadows.isOn() && !castsShadows(drawing)) {
        widgets.sentence("So no shadows are drawn now.");
    }
    choose(widgets, "edges", render::kAntialiases, drawing.effects.antialias);
    choose(widgets, "tone mapping", render::kToneMaps, drawing.effects.finish.toneMap);
    chooseLength(widgets, "occlusion", drawing.effects.occlusion.radius);
    if (hasLayers(drawing.targets.kind)) {
        widgets.checkbox("on each cascade alone", drawing.effects.occlusion.perLayer);
    }
    widgets.sentence(explanationOf(drawing.effects.occlusion));
    chooseLength(widgets, "fog", drawing.effects.fog.visibility);
    widgets.sentence(explanationOf(drawing.effects.fog));
    if (drawing.targets.kind == render::TargetsKind::layers) {
        chooseLength(widgets, "focus", drawing.focus.distance);
        chooseLength(widgets, "aperture", drawing.focus.aperture);
        widgets.checkbox("fade between cascades", drawing.focus.blend);
    }
    widgets.sentence(explanationOf(drawing.focus));
}

} // namespace cdr::viewer
