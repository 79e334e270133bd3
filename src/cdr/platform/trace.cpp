#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>
#include <cdr/platform/trace.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace cdr::platform {

namespace {

using Json = nlohmann::ordered_json;
using TimePoint = Trace::Clock::time_point;

/// Tracks, in the order they are shown. Each has one number as the format's process and thread.
constexpr std::size_t kFrameTrack = 0;
constexpr std::size_t kStageTrack = 1;
constexpr std::size_t kDeviceTrack = 2;
constexpr std::size_t kFirstCascadeTrack = 1'000;
constexpr std::size_t kFirstWorkerTrack = 10'000;

constexpr const char* kExecute = "execute";

struct Span {
    TimePoint begin = TimePoint::max();
    TimePoint end = TimePoint::min();

    void extend(TimePoint otherBegin, TimePoint otherEnd) {
        begin = std::min(begin, otherBegin);
        end = std::max(end, otherEnd);
    }
};

} // namespace

/// Turns a trace into the format's events.
class Trace::Writer {
  public:
    explicit Writer(const Trace& trace) : m_trace(trace) {}

    Json write() {
        addStages();
        addJobs();
        addCascades();
        nameTracks();
        return {{"traceEvents", std::move(m_events)},
                {"displayTimeUnit", "ms"},
                {"otherData", {{"dropped_events", m_dropped}}}};
    }

  private:
    void add(std::size_t track, const std::string& name, TimePoint begin, TimePoint end, std::size_t frame,
             Json details = Json::object()) {
        using Microseconds = std::chrono::duration<double, std::micro>;
        details["frame"] = frame;
        m_tracks.insert(track);
        m_events.push_back({{"name", name},
                            {"ph", "X"},
                            {"pid", 1},
                            {"tid", track},
                            {"ts", Microseconds(begin - m_trace.m_start).count()},
                            {"dur", Microseconds(end - begin).count()},
                            {"args", std::move(details)}});
    }

    void addStages() {
        std::map<std::size_t, Span> frames;
        for (const Stage& stage : m_trace.m_stages) {
            frames[stage.frame].extend(stage.begin, stage.end);
            const bool device = std::string_view(stage.name) == kExecute;
            add(device ? kDeviceTrack : kStageTrack, stage.name, stage.begin, stage.end, stage.frame);
        }
        for (const auto& [frame, span] : frames) {
            if (frame < m_trace.m_frames.size()) {
                add(kFrameTrack, m_trace.m_frames[frame], span.begin, span.end, frame);
            } else {
                ++m_dropped;
            }
        }
        m_dropped += m_trace.m_droppedStages;
    }

    void addJobs() {
        for (std::size_t worker = 0; worker < m_trace.m_workers.size(); ++worker) {
            m_tracks.insert(kFirstWorkerTrack + worker);
            for (const auto& [frame, job] : m_trace.m_workers[worker].jobs) {
                Json details{{"job", job.index}};
                if (job.cascade) {
                    details["draws"] = job.draws;
                    m_cascades[{*job.cascade, frame}].extend(job.begin, job.end);
                }
                const std::string name =
                    job.cascade ? "cascade " + std::to_string(*job.cascade) : stageAround(job.begin);
                add(kFirstWorkerTrack + worker, name, job.begin, job.end, frame, std::move(details));
            }
            m_dropped += m_trace.m_workers[worker].dropped;
        }
    }

    void addCascades() {
        for (const auto& [key, span] : m_cascades) {
            const auto& [cascade, frame] = key;
            add(kFirstCascadeTrack + cascade, "record cascade " + std::to_string(cascade), span.begin,
                span.end, frame);
        }
    }

    /// Stages end one after the other on one thread, so they are in order.
    std::string stageAround(TimePoint time) const {
        const auto after = std::ranges::upper_bound(m_trace.m_stages, time, {}, &Stage::begin);
        if (after == m_trace.m_stages.begin() || std::prev(after)->end < time) {
            return "job";
        }
        return std::prev(after)->name;
    }

    static std::string trackName(std::size_t track) {
        if (track >= kFirstWorkerTrack) {
            return "worker " + std::to_string(track - kFirstWorkerTrack);
        }
        if (track >= kFirstCascadeTrack) {
            return "cascade " + std::to_string(track - kFirstCascadeTrack);
        }
        return track == kFrameTrack ? "frames" : track == kStageTrack ? "stages" : "device";
    }

    void nameTracks() {
        m_events.push_back({{"name", "process_name"}, {"ph", "M"}, {"pid", 1}, {"args", {{"name", "cdr"}}}});
        for (const std::size_t track : m_tracks) {
            for (const auto& [what, details] :
                 {std::pair<const char*, Json>("thread_name", {{"name", trackName(track)}}),
                  std::pair<const char*, Json>("thread_sort_index", {{"sort_index", track}})}) {
                m_events.push_back(
                    {{"name", what}, {"ph", "M"}, {"pid", 1}, {"tid", track}, {"args", details}});
            }
        }
    }

    const Trace& m_trace;
    Json m_events = Json::array();
    std::set<std::size_t> m_tracks;
    std::map<std::pair<std::size_t, std::size_t>, Span> m_cascades; ///< by cascade and frame
    std::size_t m_dropped = 0;
};

Trace::Trace(std::size_t workers) : m_frames{"before the first frame"}, m_workers(workers) {}

void Trace::beginFrame(std::string name) {
    if (m_stopped) {
        return;
    }
    ++m_frame;
    if (m_frames.size() < kMaxEventsPerTrack) {
        m_frames.push_back(std::move(name));
    }
}

void Trace::addStage(const char* name, Clock::time_point begin, Clock::time_point end) {
    if (m_stopped) {
        return;
    }
    if (m_stages.size() >= kMaxEventsPerTrack) {
        ++m_droppedStages;
        return;
    }
    m_stages.push_back({.name = name, .frame = m_frame, .begin = begin, .end = end});
}

void Trace::addJob(std::size_t worker, const Job& job) {
    if (m_stopped) {
        return;
    }
    WorkerTrack& track = m_workers[worker];
    if (track.jobs.size() >= kMaxEventsPerTrack) {
        ++track.dropped;
        return;
    }
    track.jobs.push_back({.frame = m_frame, .job = job});
}

void Trace::forget() {
    m_frames.resize(1);
    m_frame = 0;
    m_stages.clear();
    m_droppedStages = 0;
    for (WorkerTrack& track : m_workers) {
        track.jobs.clear();
        track.dropped = 0;
    }
}

std::string Trace::toJson() const {
    return textOf(Writer(*this).write(), -1);
}

void Trace::write(const std::filesystem::path& path) const {
    writeText(path, toJson());
}

} // namespace cdr::platform
