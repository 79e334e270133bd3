#include "page.h"

#include <cdr/base/error.h>
#include <cdr/page/page_files.h>
#include <cdr/platform/file.h>

#include <nlohmann/json.hpp>

#include <string>

namespace cdr::report {

void requirePage() {
    if (page::kFiles.empty()) {
        throw base::RunError(
            "this cdr was built without the report's page; run tools/setup.sh, which fetches "
            "what the page is made of, and build again with CDR_BUILD_REPORT on");
    }
}

void writePage(const std::filesystem::path& folder) {
    requirePage();
    for (const page::File& file : page::kFiles) {
        platform::writeFile(folder / file.name, file.bytes);
    }
}

void writeData(const std::filesystem::path& folder, const nlohmann::ordered_json& data) {
    // Bytes that are not UTF-8 (a driver's name may hold any) are replaced, so that the script always reads.
    const std::string json = data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
    platform::writeText(folder / "data.js", "window.cdrReport = " + json + ";\n");
}

} // namespace cdr::report
