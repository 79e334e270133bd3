#include "viewer_run.h"

#include <cdr/image/codec.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace cdr::viewer_test {

namespace fs = std::filesystem;

std::vector<std::string> RunResult::lines(const std::string& start) const {
    std::vector<std::string> found;
    std::istringstream text(out);
    for (std::string line; std::getline(text, line);) {
        if (line.rfind(start, 0) == 0) {
            found.push_back(line);
        }
    }
    return found;
}

std::vector<std::string> RunResult::states(std::size_t count) const {
    std::vector<std::string> found = lines("scene=");
    EXPECT_EQ(found.size(), count) << out << err;
    found.resize(count);
    return found;
}

RunResult runShell(const std::string& command, const fs::path& folder, const std::string& environment) {
    const std::string line = "cd '" + folder.string() + "' && export " + environment + " && " + command +
                             " >run.out 2>run.err </dev/null";
    return {{.status = test::statusOf(line),
             .out = test::readText(folder / "run.out"),
             .err = test::readText(folder / "run.err")}};
}

RunResult ViewerTest::play(const std::string& arguments, const std::string& script) {
    std::ofstream(folder() / "script") << script;
    RunResult result =
        runShell("'" CDR_VIEWER_DRIVE "' --validate --script script " + arguments, folder(), environment());
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result;
}

image::ImageRgba8 ViewerTest::drawnBy(const std::string& line) const {
    const RunResult run = runShell("'" CDR_PROGRAM "'" + line.substr(3), folder(), environment());
    EXPECT_EQ(run.status, 0) << line << "\n" << run.err;
    const std::string option = "--output=";
    return picture(line.substr(line.find(option) + option.size()));
}

image::ImageRgba8 ViewerTest::picture(const std::string& name) const {
    return readPicture(folder() / name);
}

image::ImageRgba8 readPicture(const fs::path& file) {
    const std::string bytes = test::readText(file);
    return image::decodeImage({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                              file.string());
}

std::string valueOf(const std::string& state, const std::string& name) {
    const std::string key = " " + name + "=";
    const std::size_t at = (" " + state).find(key);
    if (at == std::string::npos) {
        return {};
    }
    std::size_t begin = at + key.size() - 1;
    char end = ' ';
    if (begin < state.size() && state[begin] == '"') {
        end = '"';
        ++begin;
    }
    return state.substr(begin, state.find(end, begin) - begin);
}

double difference(const image::ImageRgba8& a, const image::ImageRgba8& b, std::uint32_t left,
                  std::uint32_t right) {
    if (a.width != b.width || a.height != b.height) {
        ADD_FAILURE() << "pictures of two sizes";
        return 0.0;
    }
    right = std::min(right, a.width);
    std::size_t differing = 0;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = left; x < right; ++x) {
            differing += a.at(x, y) != b.at(x, y) ? 1 : 0;
        }
    }
    return static_cast<double>(differing) / (static_cast<double>(right - left) * a.height);
}

double brightness(const image::ImageRgba8& picture) {
    double sum = 0.0;
    for (const image::Rgba8& pixel : picture.pixels) {
        sum += pixel[0] + pixel[1] + pixel[2];
    }
    return picture.pixels.empty() ? 0.0 : sum / (3.0 * static_cast<double>(picture.pixels.size()));
}

std::size_t colors(const image::ImageRgba8& picture) {
    return std::set<image::Rgba8>(picture.pixels.begin(), picture.pixels.end()).size();
}

} // namespace cdr::viewer_test
