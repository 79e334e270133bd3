#include "state.h"

#include <cdr/base/error.h>
#include <cdr/host/document.h>
#include <cdr/host/file.h>
#include <cdr/host/sha256.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cdr::experiments {

namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;
constexpr int kFormatVersion = 1;

/// Everything the results depend on.
std::string digestOf(const FlickerOptions& options, const gpu::DeviceInfo& device) {
    const host::BuildInfo build = host::buildInfo();
    nlohmann::ordered_json parts{{"state", kFormatVersion},
                                 {"version", build.version},
                                 {"commit", build.commit},
                                 {"device", {device.name, device.driver, device.api}},
                                 {"size", {options.width, options.height}},
                                 {"frames", options.frames},
                                 {"seed", options.seed},
                                 {"near_object", options.nearObject},
                                 {"flip_every", options.flipEvery}};
    for (const auto& [name, technique] : options.techniques) {
        parts["techniques"].push_back({name, depth::nameOf(technique.mapping), depth::nameOf(technique.split),
                                       depth::nameOf(technique.format)});
    }
    return host::sha256Of(parts.dump());
}

nlohmann::ordered_json toJson(const FlickerResult& result) {
    return {{"technique", result.technique},
            {"pixels", result.wrong.pixels},
            {"wrong", result.wrong.wrong},
            {"edge_wrong", result.wrong.edgeWrong},
            {"overlap_pixels", result.wrong.overlapPixels},
            {"overlap_wrong", result.wrong.overlapWrong},
            {"flips", result.flips.flips},
            {"flips_compared", result.flips.compared},
            {"flip_sum", result.flipSum},
            {"flip_frames", result.flipFrames},
            {"duplication_sum", result.duplicationSum},
            {"cascades", result.cascades}};
}

/// Fills in what toJson() wrote. nlohmann::json::exception for a missing field or one of another type.
void fromJson(const nlohmann::json& json, std::uint32_t frames, FlickerResult& result) {
    result.frames = frames;
    json.at("pixels").get_to(result.wrong.pixels);
    json.at("wrong").get_to(result.wrong.wrong);
    json.at("edge_wrong").get_to(result.wrong.edgeWrong);
    json.at("overlap_pixels").get_to(result.wrong.overlapPixels);
    json.at("overlap_wrong").get_to(result.wrong.overlapWrong);
    json.at("flips").get_to(result.flips.flips);
    json.at("flips_compared").get_to(result.flips.compared);
    json.at("flip_sum").get_to(result.flipSum);
    json.at("flip_frames").get_to(result.flipFrames);
    json.at("duplication_sum").get_to(result.duplicationSum);
    json.at("cascades").get_to(result.cascades);
}

FlickerState parse(const host::Bytes& bytes, const std::string& digest, const FlickerState& fresh,
                   const std::string& name) {
    const nlohmann::json json = nlohmann::json::parse(bytes);
    if (json.at("digest").get<std::string>() != digest) {
        throw base::InputError(name +
                               ": is the state of a run with other options, another version or device; "
                               "remove it or name another file");
    }
    FlickerState state = fresh;
    json.at("frames_done").get_to(state.framesDone);
    for (std::size_t i = 0; i < state.results.size(); ++i) {
        fromJson(json.at("results").at(i), state.framesDone, state.results[i]);
    }
    return state;
}

} // namespace

FlickerStateFile::FlickerStateFile(std::filesystem::path path, const FlickerOptions& options,
                                   const gpu::DeviceInfo& device)
    : m_path(std::move(path)),
      m_digest(digestOf(options, device)),
      m_frames(options.frames) {
    host::requireWritable(m_path);
}

void FlickerStateFile::load(FlickerState& state) const {
    if (!std::filesystem::exists(m_path)) {
        return;
    }
    try {
        const FlickerState loaded =
            parse(host::readFile(m_path, kMostBytes), m_digest, state, m_path.string());
        if (loaded.framesDone > m_frames) {
            throw base::InputError(m_path.string() + ": holds more frames than the run has");
        }
        state = loaded;
    } catch (const nlohmann::json::exception&) {
        throw base::InputError(m_path.string() + ": is not the state of a flicker run");
    }
}

void FlickerStateFile::save(const FlickerState& state) const {
    nlohmann::ordered_json json{{"digest", m_digest}, {"frames_done", state.framesDone}};
    for (const FlickerResult& result : state.results) {
        json["results"].push_back(toJson(result));
    }
    host::writeText(m_path, json.dump(1) + "\n");
}

} // namespace cdr::experiments
