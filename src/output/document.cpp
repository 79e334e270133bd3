#include "build_info.h"

#include <cdr/host/document.h>
#include <cdr/host/file.h>
#include <cdr/host/standard_streams.h>

#include <thread>

namespace cdr::host {

BuildInfo buildInfo() {
    return {.version = CDR_VERSION, .commit = CDR_COMMIT};
}

nlohmann::ordered_json makeDocument(const std::string& command, const DocumentDevice& device,
                                    nlohmann::ordered_json options) {
    const BuildInfo build = buildInfo();
    return {{"command", command},
            {"version", build.version},
            {"commit", build.commit},
            {"device", {{"name", device.name}, {"driver", device.driver}, {"api", device.api}}},
            {"host", {{"cpus", std::thread::hardware_concurrency()}}},
            {"options", std::move(options)},
            {"results", nlohmann::ordered_json::array()}};
}

std::string textOf(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document) {
    const std::string text = textOf(document, 2);
    if (path == "-") {
        printOutput(text);
        flushStandardOutput();
        return;
    }
    writeText(path, text);
}

} // namespace cdr::host
