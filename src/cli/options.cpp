#include "commands.h"

#include <cdr/base/error.h>
#include <cdr/host/file.h>

#include <fmt/format.h>

#include <charconv>

namespace cdr::cli {

void addJson(CLI::App& command, OutputOptions& output) {
    command
        .add_option_function<std::string>(
            "--json", [&output](const std::string& file) { output.json = file.empty() ? "-" : file; },
            "Write the results as JSON to FILE, or to standard output without one")
        ->expected(0, 1)
        ->type_name("FILE");
}

void requireJsonWritable(const OutputOptions& output) {
    if (output.json && *output.json != "-") {
        host::requireWritable(*output.json);
    }
}

PictureSize parseSize(const std::string& text) {
    PictureSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool hasWidth = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = hasWidth ? std::from_chars(width.ptr + 1, end, size.height) : width;
    if (!hasWidth || height.ec != std::errc() || height.ptr != end || size.width < 1 || size.height < 1) {
        throw base::InputError(fmt::format("size must be WIDTHxHEIGHT in pixels, such as 1280x720, not '{}'",
                                           text.substr(0, 60)));
    }
    return size;
}

} // namespace cdr::cli
