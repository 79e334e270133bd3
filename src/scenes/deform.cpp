#include <cdr/base/enum_names.h>
#include <scenes/deform.h>

namespace cdr::scenes {

namespace {

constexpr base::EnumNames<Deform, kDeforms.size()> kDeformNames{"place to deform at", {"cpu", "device"}};

} // namespace

std::string_view nameOf(Deform deform) {
    return kDeformNames.nameOf(deform == Deform::cpu ? Deform::cpu : Deform::device);
}

Deform parseDeform(std::string_view name) {
    return kDeformNames.parse(name);
}

} // namespace cdr::scenes
