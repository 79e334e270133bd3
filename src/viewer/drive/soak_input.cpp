#include "soak_input.h"

#include <viewer/session/player.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::viewer {

SoakInput::SoakInput(SoakOptions options) : m_options(std::move(options)), m_random(m_options.seed) {
    if (!m_options.scenes.empty()) {
        m_settings.scene = m_options.scenes.front();
    }
}

double SoakInput::uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(m_random() >> 11) * 0x1p-53;
}

std::size_t SoakInput::pick(std::size_t count) {
    return std::min(static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))), count - 1);
}

void SoakInput::moveMouse(CameraInput& input) {
    constexpr double kFarthestMove = 40.0; // pixels a frame
    m_drags = chance(0.03) ? !m_drags : m_drags;
    m_pans = chance(0.02) ? !m_pans : m_pans;
    const glm::dvec2 largest(m_extent.width, m_extent.height);
    const glm::dvec2 old = m_cursor;
    const double right = uniform(-kFarthestMove, kFarthestMove);
    const double down = uniform(-kFarthestMove, kFarthestMove);
    m_cursor = glm::clamp(m_cursor + glm::dvec2(right, down), glm::dvec2(0.0), largest);
    if (chance(0.01)) { // another corner of the screen
        const double x = uniform(0.0, largest.x);
        const double y = uniform(0.0, largest.y);
        m_cursor = {x, y};
    }
    const glm::dvec2 moved = m_cursor - old;
    input.cursor = m_cursor;
    input.drag = m_drags ? moved : glm::dvec2(0.0);
    input.pan = m_pans ? moved : glm::dvec2(0.0);
    input.scroll = chance(0.1) ? std::round(uniform(-3.0, 3.0)) : 0.0;
}

void SoakInput::changeFinish() {
    constexpr double kOff = 0.5;
    const auto lengthOrOff = [&](double longest) { return chance(kOff) ? 0.0 : uniform(0.1, longest); };
    render::RenderOptions& drawing = m_settings.drawing;
    switch (pick(6)) {
    case 0:
        drawing.effects.antialias = render::kAntialiases.at(pick(render::kAntialiases.size()));
        break;
    case 1:
        drawing.effects.occlusion = {.radius = lengthOrOff(10.0), .perLayer = chance(0.5)};
        break;
    case 2:
        drawing.effects.fog.visibility = lengthOrOff(1e6);
        break;
    case 3:
        drawing.focus = {.distance = lengthOrOff(1e3), .aperture = uniform(0.1, 10.0), .blend = chance(0.5)};
        break;
    case 4:
        drawing.shadows.method = render::kShadowMethods.at(pick(render::kShadowMethods.size()));
        break;
    default:
        drawing.translucency.method = drawing.translucency.method == render::Translucency::weighted
                                          ? render::Translucency::sorted
                                          : render::Translucency::weighted;
    }
}

/// One choice at a time, as a person would.
void SoakInput::changeSettings() {
    static constexpr std::array<std::string_view, 6> kSplits{"none",   "ratio:1000", "count:4",
                                                             "fitted", "minimax:3",  "at:10,1000"};
    ViewSettings& s = m_settings;
    depth::Technique& technique = s.second && chance(0.5) ? *s.second : s.technique;
    switch (pick(13)) {
    case 0:
    case 1:
        technique = presetOfKey(1 + pick(kPresetKeys));
        break;
    case 2:
        technique.mapping = depth::kMappings.at(pick(depth::kMappings.size()));
        break;
    case 3:
        technique.split = depth::parseSplit(kSplits.at(pick(kSplits.size())));
        break;
    case 4:
        technique.format = depth::kDepthFormats.at(pick(depth::kDepthFormats.size()));
        break;
    case 5:
        s.drawing.targets = render::kTargetsKinds.at(pick(render::kTargetsKinds.size()));
        break;
    case 6:
        s.drawing.threads = 1 + pick(std::max<std::size_t>(m_options.mostThreads, 1));
        break;
    case 7:
        s.drawing.submission = render::kSubmissions.at(pick(render::kSubmissions.size()));
        break;
    case 8:
        s.second = s.second ? std::nullopt : std::optional(presetOfKey(1 + pick(kPresetKeys)));
        s.divider = uniform(0.0, 1.0);
        break;
    case 9:
        changeFinish();
        break;
    case 10:
        s.view = kViewKinds.at(pick(kViewKinds.size()));
        break;
    case 11:
        s.drawing.snapping = render::kSnappings.at(pick(render::kSnappings.size()));
        break;
    default:
        s.drawing.batching = render::kBatchings.at(pick(render::kBatchings.size()));
    }
}

SoakStep SoakInput::next() {
    SoakStep step;
    for (std::size_t key = 0; key < kCameraKeys; ++key) {
        // Held for about a second.
        const auto cameraKey = static_cast<CameraKey>(key);
        if (chance(m_keys.has(cameraKey) ? 0.05 : 0.01)) {
            m_keys.set(cameraKey, !m_keys.has(cameraKey));
        }
    }
    if (chance(0.01)) {
        const PictureExtent& largest = m_options.largest;
        const auto side = [&](double most) { // small windows as often as large ones
            return static_cast<std::uint32_t>(std::lround(std::exp(uniform(0.0, std::log(most)))));
        };
        m_extent.width = std::clamp(side(largest.width), 1u, largest.width);
        m_extent.height = std::clamp(side(largest.height), 1u, largest.height);
        step.resize = m_extent;
    }
    if (chance(0.03)) {
        changeSettings();
        step.settings = m_settings;
    }
    if (chance(0.002) && !m_options.scenes.empty()) {
        chooseScene(m_settings, m_options.scenes[pick(m_options.scenes.size())]);
        step.settings = m_settings;
    }
    m_orbits = chance(0.01) ? !m_orbits : m_orbits;
    step.orbits = m_orbits;
    step.zooms = chance(0.5);
    moveMouse(step.input);
    step.input.keys = m_keys;
    step.input.seconds = Player::kStepSeconds;
    step.input.extent = m_extent;
    if (chance(0.02)) {
        const std::size_t x = pick(m_extent.width);
        const std::size_t y = pick(m_extent.height);
        step.click = glm::uvec2(x, y);
    }
    step.minimises = chance(0.002);
    step.screenshot = chance(0.002);
    step.returnsHome = chance(0.01);
    return step;
}

} // namespace cdr::viewer
