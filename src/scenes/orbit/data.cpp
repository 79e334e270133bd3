#include <cdr/base/error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <scenes/orbit/data.h>

#include <cstdlib>
#include <system_error>

namespace cdr::scenes {

namespace {

constexpr std::uintmax_t kMaxBytes = 64ull << 20;

image::ImageRgba8 loadPicture(const std::filesystem::path& path) {
    std::error_code error; // of a folder that cannot be read, or a name that is too long
    if (!std::filesystem::is_regular_file(path, error)) {
        throw base::InputError("orbit: " + path.string() +
                               " is missing; tools/setup.sh fetches it, or set CDR_ORBIT_DATA to its folder");
    }
    return image::decodeImage(platform::readFile(path, kMaxBytes), path.string());
}

const char* environmentOr(const char* name, const char* otherwise) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' ? value : otherwise;
}

} // namespace

OrbitFiles orbitFiles() {
    return {.folder = environmentOr("CDR_ORBIT_DATA", CDR_ORBIT_DATA_FOLDER),
            .model = environmentOr("CDR_ORBIT_MODEL", "")};
}

std::array<std::filesystem::path, 2> earthFiles(const std::filesystem::path& folder) {
    return {folder / kEarthColor, folder / kEarthTopography};
}

EarthMaps loadEarthMaps(const std::filesystem::path& folder) {
    const auto [color, topography] = earthFiles(folder);
    return {.color = loadPicture(color), .topography = loadPicture(topography)};
}

} // namespace cdr::scenes
