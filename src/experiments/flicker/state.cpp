#include "state.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>

#include <nlohmann/json.hpp>
#include <program/build_info.h>
#include <program/sha256.h>

#include <cmath>
#include <limits>

namespace cdr::experiments {

namespace {

constexpr std::uintmax_t kMaxBytes = 1 << 20;
constexpr int kFormatVersion = 2;

/// Everything the results depend on.
std::string digestOf(const FlickerOptions& options, const gpu::DeviceInfo& device) {
    const program::BuildInfo build = program::buildInfo();
    nlohmann::ordered_json parts{{"state", kFormatVersion},
                                 {"version", build.version},
                                 {"commit", build.commit},
                                 {"device", {device.name, device.driver, device.api}},
                                 {"size", {options.width, options.height}},
                                 {"frames", options.frames},
                                 {"seed", options.seed},
                                 {"snap_bits", options.snapBits},
                                 {"near_object", options.nearObject},
                                 {"flip_every", options.flipEvery}};
    for (const auto& [name, technique] : options.techniques) {
        parts["techniques"].push_back({name, depth::nameOf(technique.mapping), depth::nameOf(technique.split),
                                       depth::nameOf(technique.format)});
    }
    for (const rivals::NamedRival& named : options.rivalsBeside) {
        parts["rivals"].push_back(named.name);
    }
    return program::sha256Of(platform::textOf(parts, -1));
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

/// A count as toJson() wrote it; a negative or fractional number would become another.
template <typename Count>
void readCount(const nlohmann::json& json, const char* name, Count& count) {
    const nlohmann::json& number = json.at(name);
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > std::numeric_limits<Count>::max()) {
        throw base::InputError(std::string(name) + " is not a count");
    }
    number.get_to(count);
}

/// Fills in what toJson() wrote. nlohmann::json::exception for a missing field or one of another type.
void fromJson(const nlohmann::json& json, std::uint32_t frames, FlickerResult& result) {
    result.frames = frames;
    readCount(json, "pixels", result.wrong.pixels);
    readCount(json, "wrong", result.wrong.wrong);
    readCount(json, "edge_wrong", result.wrong.edgeWrong);
    readCount(json, "overlap_pixels", result.wrong.overlapPixels);
    readCount(json, "overlap_wrong", result.wrong.overlapWrong);
    readCount(json, "flips", result.flips.flips);
    readCount(json, "flips_compared", result.flips.compared);
    json.at("flip_sum").get_to(result.flipSum);
    readCount(json, "flip_frames", result.flipFrames);
    json.at("duplication_sum").get_to(result.duplicationSum);
    readCount(json, "cascades", result.cascades);
}

/// Whether that many frames of `pixels` pixels can have come to such sums.
bool canBe(const FlickerResult& result, std::uint32_t frames, std::uint64_t pixels) {
    const auto isSumOfShares = [](double sum, std::uint64_t count) {
        return sum >= 0.0 && sum <= static_cast<double>(count);
    };
    const std::uint64_t all = pixels * frames;
    const auto& wrong = result.wrong;
    return wrong.pixels <= all && wrong.wrong <= wrong.pixels && wrong.edgeWrong <= all &&
           wrong.overlapPixels <= wrong.pixels && wrong.overlapWrong <= wrong.overlapPixels &&
           result.flips.compared <= all && result.flips.flips <= result.flips.compared &&
           result.flipFrames <= frames && isSumOfShares(result.flipSum, result.flipFrames) &&
           result.duplicationSum >= 0.0 && std::isfinite(result.duplicationSum) &&
           result.cascades <= depth::kMaxCascades;
}

/// Without its sum.
nlohmann::ordered_json toJson(const FlickerRun& run, const FlickerState& state) {
    nlohmann::ordered_json json{{"digest", run.digest}, {"frames_done", state.framesDone}};
    for (const FlickerResult& result : state.results) {
        json["results"].push_back(toJson(result));
    }
    return json;
}

std::string stateSumOf(const nlohmann::ordered_json& json) {
    return program::sha256Of(platform::textOf(json, -1));
}

FlickerState parse(std::string_view text, const FlickerRun& run, const FlickerState& fresh) {
    const nlohmann::json json = nlohmann::json::parse(text);
    FlickerState state = unsummedState(json, run, fresh);
    // Of what was read and not of the text, which may be nested so deeply that writing it again would overflow the stack.
    if (!json.contains("sha256") || json.at("sha256") != stateSumOf(toJson(run, state))) {
        throw base::InputError("is damaged");
    }
    return state;
}

} // namespace

FlickerState unsummedState(const nlohmann::json& json, const FlickerRun& run, const FlickerState& fresh) {
    if (json.at("digest").get<std::string>() != run.digest) {
        throw base::InputError("is the state of a run with other options, another version or device");
    }
    FlickerState state = fresh;
    readCount(json, "frames_done", state.framesDone);
    if (state.framesDone > run.frames) {
        throw base::InputError("holds more frames than the run has");
    }
    const nlohmann::json& results = json.at("results");
    if (results.size() != state.results.size()) {
        throw base::InputError("holds results of other techniques than the run has");
    }
    for (std::size_t i = 0; i < state.results.size(); ++i) {
        FlickerResult& result = state.results[i];
        if (results.at(i).at("technique").get<std::string>() != result.technique) {
            throw base::InputError("holds results of other techniques than the run has");
        }
        fromJson(results.at(i), state.framesDone, result);
        if (!canBe(result, state.framesDone, run.pixels)) {
            throw base::InputError("holds counts that are impossible for this run");
        }
    }
    return state;
}

FlickerState readState(std::string_view text, const FlickerRun& run, const FlickerState& fresh,
                       const std::string& name) {
    std::string what;
    try {
        return parse(text, run, fresh);
    } catch (const nlohmann::json::exception&) {
        what = "is not the state of a flicker run";
    } catch (const base::InputError& error) {
        what = error.what();
    }
    throw base::inputError("{}: {}; remove it or name another file", name, what);
}

std::string stateTextOf(const FlickerRun& run, const FlickerState& state) {
    nlohmann::ordered_json json = toJson(run, state);
    json["sha256"] = stateSumOf(json);
    return platform::textOf(json, 1);
}

FlickerStateFile::FlickerStateFile(std::filesystem::path path, const FlickerOptions& options,
                                   const gpu::DeviceInfo& device)
    : m_path(std::move(path)),
      m_run({.digest = digestOf(options, device),
             .frames = options.frames,
             .pixels = std::uint64_t{options.width} * options.height}) {
    platform::requireWritable(m_path);
}

void FlickerStateFile::load(FlickerState& state) const {
    std::error_code error; // readFile() says what is wrong with a file that may be there
    if (std::filesystem::status(m_path, error).type() == std::filesystem::file_type::not_found) {
        return;
    }
    const platform::Bytes bytes = platform::readFile(m_path, kMaxBytes);
    state =
        readState({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, m_run, state, m_path.string());
}

void FlickerStateFile::save(const FlickerState& state) const {
    platform::writeText(m_path, stateTextOf(m_run, state));
}

} // namespace cdr::experiments
