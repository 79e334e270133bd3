#include <cdr/base/enum_names.h>
#include <cdr/render/surface_path.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<SurfacePath, kSurfacePaths.size()> kNames{"surface", {"gbuffer", "visibility"}};

} // namespace

std::string_view nameOf(SurfacePath path) {
    return kNames.nameOf(path);
}

SurfacePath parseSurfacePath(std::string_view name) {
    return kNames.parse(name);
}

} // namespace cdr::render
