#include <cdr/base/enum_names.h>
#include <cdr/render/geometry/snapping.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<Snapping, kSnappings.size()> kSnappingNames{"snapping", {"by-device", "in-plane"}};

} // namespace

std::string_view nameOf(Snapping snapping) {
    return kSnappingNames.nameOf(snapping);
}

Snapping parseSnapping(std::string_view name) {
    return kSnappingNames.parse(name);
}

} // namespace cdr::render
