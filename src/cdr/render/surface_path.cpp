#include <cdr/base/enum_names.h>
#include <cdr/render/surface_path.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<SurfacePath, kSurfacePaths.size()> kSurfaceNames{"surface",
                                                                           {"gbuffer", "visibility", "lit"}};

} // namespace

std::string_view nameOf(SurfacePath path) {
    return kSurfaceNames.nameOf(path);
}

SurfacePath parseSurfacePath(std::string_view name) {
    return kSurfaceNames.parse(name);
}

} // namespace cdr::render
