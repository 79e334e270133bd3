#include "gnuplot.h"

#include "whole_file.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/platform/file.h>

#include <program/child_process.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cdr::output {

namespace {

bool isPng(const std::filesystem::path& path) {
    return platform::lowerExtension(path) == ".png";
}

} // namespace

void requirePlottable(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 2> kExtensions{".png", ".svg"};
    const std::string extension = platform::lowerExtension(path);
    if (std::find(kExtensions.begin(), kExtensions.end(), extension) == kExtensions.end()) {
        throw base::InputError(base::unknownName("plot format", extension, kExtensions));
    }
    if (!program::isInstalled("gnuplot")) {
        throw base::InputError("plots need gnuplot, which is not installed (Debian, Ubuntu: gnuplot-nox)");
    }
}

void writePlot(const std::filesystem::path& path, const std::string& script) {
    const char* terminal = isPng(path) ? "set terminal pngcairo noenhanced size 1200,700 font 'sans,11'\n"
                                       : "set terminal svg noenhanced size 1200,700 font 'sans,14' "
                                         "background 'white'\n";
    const std::string input = terminal + script;
    platform::writeBesideThenRename(path, [&](const std::filesystem::path& temporary) {
        // -d: start-up files of the user are not read.
        program::ChildProcess gnuplot({"gnuplot", "-d", "-"}, {.file = temporary});
        gnuplot.write({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
        gnuplot.finish();
        requireWhole(temporary, path, "gnuplot");
    });
}

std::string gnuplotQuote(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') {
            quoted += "''"; // as gnuplot writes a quote within quotes
        } else {
            quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return quoted + "'";
}

} // namespace cdr::output
