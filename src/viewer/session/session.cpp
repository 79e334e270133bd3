#include "session.h"

#include <cdr/base/error.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/stereo_view.h>
#include <viewer/state/requests/next_request.h>
#include <viewer/state/tour.h>
#include <viewer/window/window.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace cdr::viewer {

namespace {

/// While the camera moves, frames that picking can read come this often.
constexpr std::chrono::milliseconds kSurfacesEvery{100};
constexpr std::chrono::seconds kRateWindow{1};

/// Whether each frame of the scene's path shows the same.
bool isStill(const scene::SceneSetup& setup) {
    return setup.path.frames <= 1 && !setup.motion;
}

/// Whether a result shows the scene that was shown before, if perhaps opened anew: in other colours, for levels of
/// detail or with another animation. A file that was asked for again may be another.
bool isOfSameScene(const RenderResult* before, const RenderResult& result) {
    return before != nullptr && before->sceneName == result.sceneName &&
           before->settings.openings == result.settings.openings;
}

} // namespace

Session::Session(RenderDevice& device, ViewerModel& model) : m_device(device), m_model(model) {
    startThread();
}

void Session::startThread() {
    m_thread.emplace(m_device.device(), [] { WindowSystem::wake(); });
}

void Session::renewDevice() {
    m_thread.reset(); // with all that it made on the device
    m_device.renew();
    startThread();
    m_click.reset();
    m_asked.reset();
    m_pending.clear();
}

void Session::followPath(double seconds) {
    // A tour waits while another scene is opened.
    const bool isOnTour = m_model.camera.motion == Motion::tour && m_model.settings.scene == kTourScene;
    const bool isShown = m_model.picture.shown != nullptr;
    if (isShown && (m_model.camera.motion == Motion::recording || isOnTour)) {
        m_model.camera.playedSeconds += seconds;
    }
    if (m_model.camera.motion == Motion::free || !isShown || !m_thread->isReady()) {
        return;
    }
    if (m_model.camera.motion == Motion::scenePath) {
        if (isStill(m_model.picture.shown->scene->setup)) {
            m_model.camera.motion = Motion::free; // there is nowhere to go
            return;
        }
        if (isAnimated()) { // what moves goes by time, and the camera with it
            playAnimation();
            return;
        }
        // Frame by frame, however long each takes, so that neighbours can be compared.
        goTo(++m_model.camera.pathFrame);
        return;
    }
    if (m_model.camera.motion == Motion::tour) {
        followTour();
        return;
    }
    const scene::CameraRecording& recording = m_model.camera.recorder.recording();
    if (m_model.camera.playedSeconds > recording.seconds()) {
        m_model.camera.motion = Motion::free;
    }
    m_model.camera.now = cameraAt(recording, m_model.camera.playedSeconds);
}

bool Session::isAnimated() const {
    const RenderResult* shown = m_model.picture.shown.get();
    return shown != nullptr && shown->scene->setup.path.frames > 1 && shown->settings.choice.framesPerSecond;
}

void Session::playAnimation() {
    CameraModel& camera = m_model.camera;
    camera.motion = Motion::free;
    camera.followsAnimation = true;
    if (!camera.playback.isPlaying) {
        camera.playback.toggle(playableSeconds(m_model.settings.choice, *m_model.picture.shown->scene));
    }
}

void Session::followAnimation(double seconds) {
    const bool isOpen = m_model.picture.shown != nullptr &&
                        m_model.picture.shown->sceneName == m_model.settings.scene &&
                        m_model.picture.shown->settings.choice == m_model.settings.choice;
    if (!isOpen) {
        return;
    }
    const scene::OpenedScene& scene = *m_model.picture.shown->scene;
    CameraModel& camera = m_model.camera;
    camera.playback.advance(seconds, playableSeconds(m_model.settings.choice, scene));
    const std::uint32_t frame = camera.playback.frame(m_model.settings.choice);
    if (isAnimated() && camera.motion == Motion::free && camera.followsAnimation &&
        camera.animatedFrame != frame) {
        camera.animatedFrame = frame;
        goTo(frame);
    }
}

void Session::goTo(std::uint32_t frame) {
    const scene::Camera own = m_model.picture.shown->scene->setup.path.at(frame);
    try {
        m_model.camera.now = scene::canonical(options::overridden(own, m_model.camera.lens));
    } catch (const base::InputError& error) { // the lens told and the path's own do not fit each other there
        m_model.interface.sayProblem(error.what());
        m_model.camera.motion = Motion::free;
        m_model.camera.playback.isPlaying = false;
    }
}

void Session::followTour() {
    const bool isOpen = m_model.picture.shown->sceneName == m_model.settings.scene;
    if (m_model.settings.scene != kTourScene) { // another one was asked for, which may not open
        m_model.camera.motion = isOpen ? Motion::free : Motion::tour;
        return;
    }
    if (!isOpen) {
        m_model.camera.playedSeconds = 0.0; // it is still being opened
        return;
    }
    const scene::CameraPath& path = m_model.picture.shown->scene->setup.path;
    m_model.camera.pathFrame = tourFrame(m_model.camera.playedSeconds, path.frames);
    m_model.camera.now = scene::canonical(path.at(m_model.camera.pathFrame));
    if (m_model.camera.playedSeconds >= kTourSeconds) {
        m_model.camera.motion = Motion::free;
        m_model.interface.say(std::string(tourCaption(scene::degreesOf(m_model.camera.now.fovY))));
    }
}

std::uint32_t Session::frameOfMotion() const {
    return m_model.settings.choice.framesPerSecond ? m_model.camera.playback.frame(m_model.settings.choice)
                                                   : m_model.camera.pathFrame;
}

RenderRequest Session::wantedRequest(const PictureArea& area) const {
    RenderRequest request{
        .serial = m_serial + 1, .settings = m_model.settings, .extent = area.extent, .camera = {}};
    request.settings.divider = 0.5; // both sides are whole pictures, so it need not be rendered again
    const bool isOpen =
        m_model.picture.shown != nullptr && m_model.picture.shown->sceneName == m_model.settings.scene;
    if (isOpen && m_model.camera.isThere) {
        request.camera = m_model.camera.now;
    }
    if (isOpen && m_model.picture.shown->scene->setup.motion) {
        request.frame = frameOfMotion();
    }
    return request;
}

void Session::recordCamera(double seconds) {
    PathRecorder& recorder = m_model.camera.recorder;
    if (recorder.isRecording() && (recorder.recording().scene != m_model.picture.shown->sceneName ||
                                   !recorder.add(seconds, m_model.camera.now))) {
        m_model.actions.push_back(Action::record); // another scene is shown, or it is full
    }
}

void Session::update(const SessionInput& input) {
    while (!m_pending.empty() && m_pending.front().serial <= m_shownSerial) {
        m_pending.pop_front();
    }
    m_model.performance.lagSeconds =
        m_pending.empty() ? 0.0 : std::chrono::duration<double>(Clock::now() - m_pending.front().at).count();
    m_isIdle = false;
    if (m_click && !m_click->serial) {
        pickOrAsk();
    }
    if (m_click) {
        recordCamera(input.seconds);
        return; // the picture that was clicked on comes first
    }
    followPath(input.seconds);
    followAnimation(input.seconds);
    recordCamera(input.seconds);
    readCursor(input.area, input.cursor);
    const auto now = Clock::now();
    RenderRequest request = wantedRequest(input.area);
    request.isSteered = input.isSteered || (m_model.camera.motion == Motion::free && m_asked.has_value() &&
                                            m_asked->camera != request.camera);
    const bool isFading =
        fades(m_model.picture.shown.get()) && m_model.picture.shown->serial == m_shownSerial;
    const bool movesByItself =
        input.isSteered || m_model.camera.motion != Motion::free || m_model.camera.playback.isPlaying;
    Wanted wanted{.request = std::move(request),
                  .isFlying = movesByItself || input.isDragged,
                  .rendersAlways = m_model.performance.rendersAlways || isFading,
                  .surfacesAreDue = (input.area.contains(input.cursor) || input.isSteered) &&
                                    now - m_surfacesAsked >= kSurfacesEvery,
                  .isThreadReady = m_thread->isReady()};
    const bool changes = movesByItself || wanted.rendersAlways || !wanted.isThreadReady;
    auto next = decide(m_asked ? &*m_asked : nullptr, std::move(wanted));
    m_isIdle = !next && !changes;
    if (!next) {
        return;
    }
    if (next->wantsSurfaces) {
        m_surfacesAsked = now;
    }
    ask(*std::move(next));
}

void Session::ask(RenderRequest request) {
    m_serial = request.serial;
    m_pending.push_back({.serial = m_serial, .at = Clock::now()});
    m_asked = request;
    m_thread->request(std::move(request));
}

bool Session::takeOpening() {
    const auto opening = m_thread->takeOpening();
    if (!opening || isSettled()) {
        return false;
    }
    m_model.interface.say(textOf(*opening), NoticeKind::opening);
    return true;
}

bool Session::takeResult() {
    std::optional<RenderResult> result = m_thread->take();
    if (!result) {
        return false;
    }
    m_thread->takeOpening(); // told before this result
    if (result->fatal) {
        std::rethrow_exception(result->fatal);
    }
    if (m_click && m_click->serial == result->serial) {
        takeClicked(*result);
        return false;
    }
    m_shownSerial = result->serial;
    ++m_results;
    if (!result->failure) {
        adopt(std::move(*result));
        return true;
    }
    if (m_asked && m_asked->serial == result->serial) { // not repeated for what it lacks
        m_asked->wantsSurfaces = m_asked->countsWrong = m_asked->isAtRest = true;
    }
    const bool isFirst = m_model.picture.shown == nullptr;
    const bool isWanted = m_model.settings.scene == result->settings.scene &&
                          m_model.settings.openings == result->settings.openings;
    if (isFirst && isWanted) {
        std::rethrow_exception(result->failure->error);
    }
    m_model.interface.sayProblem(result->failure->message);
    if (isFirst) {
        return false; // another scene was asked for meanwhile
    }
    if (m_model.camera.motion == Motion::tour && result->settings.scene == kTourScene) {
        m_model.camera.motion = Motion::free; // it would fail again
    }
    m_model.settings = settingsAfterFailure(m_model.settings, result->settings, m_good);
    return false;
}

void Session::adopt(RenderResult result) {
    const RenderResult* before = m_model.picture.shown.get();
    const bool isEntered = !isOfSameScene(before, result);
    if (before == nullptr || before->scene != result.scene) {
        takeOpened(result);
    }
    if (isEntered) {
        enterScene(result);
    }
    count(result);
    const std::size_t sides = result.sides.size();
    for (std::size_t side = 0; side < m_model.picture.readable.size(); ++side) {
        if (side >= sides) {
            m_model.picture.readable[side].reset();
        } else if (!result.sides[side].frame->gbuffer.pixels.empty()) {
            m_model.picture.readable[side] = result.sides[side].frame;
        }
    }
    const bool isReadable = !result.sides.front().frame->gbuffer.pixels.empty();
    if (isReadable) {
        const render::Frame& frame = *result.sides.front().frame;
        const double seen = surfaceView(frame, middleOf(frame));
        m_model.picture.seesNothing = !std::isfinite(seen);
        // The camera flew on while the picture was made.
        const double ahead = isEntered ? seen : surfaceAhead(m_model.camera.now, result.camera, seen);
        m_model.camera.surfaceView =
            ahead > 0.0 ? flightDistance(m_model.camera.now, ahead, m_model.camera.surfaceView)
                        : m_model.camera.now.nearView;
        if (m_pivotFrom && result.serial >= *m_pivotFrom) {
            m_pivotFrom.reset();
            const double pivotView = ahead > 0.0 && std::isfinite(ahead) ? ahead : m_model.camera.surfaceView;
            m_model.camera.pivot = m_model.camera.now.position - m_model.camera.now.back * pivotView;
        }
    }
    takeWrong(result);
    m_good = result.settings;
    m_model.picture.shown = std::make_shared<const RenderResult>(std::move(result));
}

/// What was counted of other techniques or another scene says nothing of these.
void Session::takeWrong(const RenderResult& result) {
    std::vector<WrongCount> counts;
    for (const SideResult& side : result.sides) {
        if (side.wrong) {
            counts.push_back(*side.wrong);
        }
    }
    m_model.picture.isWrongCurrent = counts.size() == result.sides.size();
    const bool isOther = m_model.picture.shown == nullptr || m_model.picture.shown->scene != result.scene ||
                         m_good.technique != result.settings.technique ||
                         m_good.second != result.settings.second || m_good.layers != result.settings.layers;
    if (m_model.picture.isWrongCurrent || isOther) {
        m_model.picture.wrong =
            m_model.picture.isWrongCurrent ? std::move(counts) : std::vector<WrongCount>();
    }
}

void Session::click(const glm::dvec2& pixel) {
    if (m_model.picture.shown == nullptr || !m_asked) {
        return;
    }
    const glm::dvec2 size(m_asked->extent.width, m_asked->extent.height);
    m_click = Click{.share = glm::clamp(pixel / size, glm::dvec2(0.0), glm::dvec2(1.0)),
                    .divider = m_model.settings.divider,
                    .shown = m_model.picture.shown,
                    .serial = {}};
    m_model.picture.clickedCamera = m_model.picture.shown->camera;
}

void Session::pickOrAsk() {
    const RenderResult& shown = *m_click->shown;
    if (!shown.sides.front().frame->gbuffer.pixels.empty()) {
        pick(*m_click, shown);
        m_click.reset();
        return;
    }
    const auto isOther = [&](const ViewSettings& settings) {
        return settings.scene != shown.sceneName || settings.openings != shown.settings.openings;
    };
    if (isOther(m_model.settings) || isOther(m_asked->settings)) {
        m_click.reset(); // another scene is being opened
        return;
    }
    const image::ImageRgba8& picture = *shown.sides.front().picture;
    ask({.serial = m_serial + 1,
         .settings = shown.settings,
         .extent = {picture.width, picture.height},
         .camera = shown.camera,
         .frame = shown.frame});
    m_click->serial = m_serial;
}

void Session::takeClicked(const RenderResult& result) {
    if (!result.failure) {
        pick(*m_click, result);
    } else {
        m_model.interface.sayProblem(result.failure->message);
    }
    m_click.reset();
    m_pending.clear();
    m_asked.reset(); // this picture was not for showing, so what is wanted is asked for again
}

void Session::pick(const Click& click, const RenderResult& result) {
    const SideResult& side =
        result.sides.size() > 1 && click.share.x >= click.divider ? result.sides[1] : result.sides[0];
    const render::Frame& frame = *side.frame;
    const auto at = [](double share, std::uint32_t size) {
        return std::min(static_cast<std::uint32_t>(share * size), size - 1);
    };
    const auto point =
        pickAt(frame, result.scene->setup.scene, side.options.technique,
               at(click.share.x, columnsShown(result.settings, frame)), at(click.share.y, frame.height()));
    if (point) {
        m_model.picture.measuring.click(*point);
        // Not in the result's scene, which may have been opened in other colours.
        m_model.picture.pickedMaterials =
            m_model.picture.measuring.materialsIn(m_model.picture.shown->scene->setup.scene);
        m_model.camera.pivot = point->position;
        m_pivotFrom.reset();
    }
}

void Session::takeOpened(const RenderResult& result) {
    if (m_model.interface.notice.kind == NoticeKind::opening) {
        m_model.interface.notice = {};
    }
    if (m_click && !m_click->serial) {
        m_click.reset(); // on what is gone
    }
    m_model.camera.ofScene = result.scene->setup.path.at(0);
    m_model.camera.animatedFrame.reset();
    m_model.performance.statistics.clear();
    m_model.picture.underCursor = {};
    m_model.picture.readable = {};
    m_model.picture.pickedMaterials = m_model.picture.measuring.materialsIn(result.scene->setup.scene);
}

void Session::enterScene(const RenderResult& result) {
    const scene::CameraPath& path = result.scene->setup.path;
    const auto first = std::exchange(m_model.camera.first, std::nullopt);
    const bool isReopened =
        m_model.picture.shown != nullptr && m_model.picture.shown->sceneName == result.sceneName;
    if (!isReopened) {
        const options::CameraOptions told = first.value_or(options::CameraOptions{});
        m_model.camera.lens = options::lensOf(told);
        m_model.camera.followsAnimation = !(told.eye || told.target || told.direction || told.up);
    }
    m_model.camera.pathFrame = first ? first->frame : 0;
    if (first) {
        m_model.camera.now = scene::canonical(overridden(path.at(frameOfMotion()), *first));
    } else if (!isReopened) { // else it flew on meanwhile
        m_model.camera.now = scene::canonical(result.camera);
    }
    m_model.camera.isThere = true;
    m_model.picture.measuring.clear();
    aimFrom(result.serial);
}

void Session::aimAnew() {
    aimFrom(m_serial + 1); // what was asked for until now shows where the camera was
}

void Session::aimFrom(std::uint64_t serial) {
    m_model.camera.surfaceView = 0.0;
    m_model.camera.pivot = m_model.camera.now.position - m_model.camera.now.back;
    m_pivotFrom = serial;
}

void Session::readCursor(const PictureArea& area, const glm::dvec2& cursor) {
    for (std::size_t side = 0; side < m_model.picture.underCursor.size(); ++side) {
        const std::shared_ptr<const render::Frame>& frame = m_model.picture.readable[side];
        m_model.picture.underCursor[side].reset();
        if (frame == nullptr || !area.contains(cursor) || m_model.picture.shown->sides.size() <= side) {
            continue;
        }
        // The frame may be of another size while the window changes its own.
        const glm::dvec2 share = cursor / glm::dvec2(area.extent.width, area.extent.height);
        m_model.picture.underCursor[side] = pickAt(
            *frame, m_model.picture.shown->scene->setup.scene,
            m_model.picture.shown->sides[side].options.technique,
            static_cast<std::uint32_t>(share.x * columnsShown(m_model.picture.shown->settings, *frame)),
            static_cast<std::uint32_t>(share.y * frame->height()));
    }
}

void Session::count(const RenderResult& result) {
    StageTimes times;
    for (const SideResult& side : result.sides) {
        const render::FrameTimes& ms = side.frame->stats.times;
        times[FrameStage::cull] += static_cast<float>(ms.cullMs + ms.occludersMs);
        times[FrameStage::split] += static_cast<float>(ms.splitMs);
        times[FrameStage::bin] += static_cast<float>(ms.binMs + ms.translucentMs + ms.shadowsMs);
        times[FrameStage::record] += static_cast<float>(ms.recordMs);
        times[FrameStage::execute] += static_cast<float>(ms.executeMs);
    }
    times[FrameStage::composite] = static_cast<float>(result.compositeMs);
    times[FrameStage::present] = static_cast<float>(m_model.performance.presentMs);
    m_model.performance.statistics.add(times);
    const auto now = Clock::now();
    m_arrivals.push_back(now);
    while (m_arrivals.size() > 2 && now - m_arrivals.front() > kRateWindow) {
        m_arrivals.pop_front();
    }
    const double span = std::chrono::duration<double>(now - m_arrivals.front()).count();
    m_model.performance.framesPerSecond =
        span > 0.0 ? static_cast<double>(m_arrivals.size() - 1) / span : 0.0;
}

} // namespace cdr::viewer
