#include <cdr/platform/file.h>
#include <cdr/platform/json_text.h>
#include <cdr/platform/standard_streams.h>

#include <output/document.h>

namespace cdr::output {

void writeDocument(const std::filesystem::path& path, const nlohmann::ordered_json& document) {
    const std::string text = platform::textOf(document, 2);
    if (path == "-") {
        platform::printNow(text);
        return;
    }
    platform::writeText(path, text);
}

} // namespace cdr::output
