#include <cdr/base/error.h>
#include <cdr/base/file.h>
#include <cdr/image/codec.h>
#include <cdr/scene/orbit_data.h>

#include <cstdlib>

namespace cdr::scene {

namespace {

constexpr std::uintmax_t kMostBytes = 64ull << 20;

image::ImageRgba8 loadPicture(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw base::InputError("orbit: " + path.string() +
                               " is missing; tools/setup.sh fetches it, or set CDR_ORBIT_DATA to its folder");
    }
    return image::decodeImage(base::readFile(path, kMostBytes), path.string());
}

} // namespace

std::filesystem::path orbitDataFolder() {
    const char* folder = std::getenv("CDR_ORBIT_DATA");
    return folder != nullptr && *folder != '\0' ? folder : CDR_ORBIT_DATA_FOLDER;
}

EarthMaps loadEarthMaps(const std::filesystem::path& folder) {
    return {.color = loadPicture(folder / "earth-blue-marble.jpg"),
            .topography = loadPicture(folder / "earth-topology.png")};
}

} // namespace cdr::scene
