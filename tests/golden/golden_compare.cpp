// golden_compare GOLDEN RENDER [SHEET]: compares a rendered picture with the golden one, within a tolerance.
// Prints one line. Writes golden, render and ten times their difference side by side to SHEET, a PNG.
// Exit status: 0 the same, 1 different, 2 a picture is missing or unreadable.

#include "../support/difference_picture.h"
#include "../support/picture_comparison.h"

#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/image/compose.h>
#include <cdr/platform/file.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace cdr;

image::ImageRgba8 readPicture(const std::string& path) {
    constexpr std::uintmax_t kMaxBytes = 64 << 20;
    return image::decodeImage(platform::readFile(path, kMaxBytes), path);
}

void writeSheet(const std::string& path, const image::ImageRgba8& golden, const image::ImageRgba8& render) {
    image::ImageRgba8 sheet(3 * golden.width, golden.height);
    image::paste(sheet, golden, 0, 0);
    image::paste(sheet, render, golden.width, 0);
    image::paste(sheet, test::differencePicture(golden, render, 10), 2 * golden.width, 0);
    image::writeImage(path, sheet);
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() < 2 || arguments.size() > 3) {
        throw base::InputError("usage: golden_compare GOLDEN RENDER [SHEET]");
    }
    const image::ImageRgba8 golden = readPicture(arguments[0]);
    const image::ImageRgba8 render = readPicture(arguments[1]);
    const test::Comparison comparison = test::compare(golden, render);
    std::printf("%s\n", test::describe(comparison).c_str());
    if (arguments.size() == 3 && comparison.sameSize) {
        writeSheet(arguments[2], golden, render);
    }
    return comparison.passes ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "golden_compare: %s\n", error.what());
        return 2;
    }
}
