#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>
#include <cdr/platform/standard_streams.h>

#include <output/document.h>
#include <program/build_info.h>

#include <thread>
#include <utility>

namespace cdr::output {

nlohmann::ordered_json makeDocument(const std::string& command, const DocumentDevice& device,
                                    nlohmann::ordered_json options) {
    const program::BuildInfo build = program::buildInfo();
    return {{"command", command},
            {"version", build.version},
            {"commit", build.commit},
            {"device", {{"name", device.name}, {"driver", device.driver}, {"api", device.api}}},
            {"host", {{"cpus", std::thread::hardware_concurrency()}}},
            {"options", std::move(options)},
            {"results", nlohmann::ordered_json::array()}};
}

void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document) {
    const std::string text = platform::textOf(document, 2);
    if (path == "-") {
        platform::printNow(text);
        return;
    }
    platform::writeText(path, text);
}

} // namespace cdr::output
