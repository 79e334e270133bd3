#include <cdr/base/enum_names.h>
#include <cdr/render/translucency/translucency.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<Translucency, kTranslucencies.size()> kNames{"translucency",
                                                                       {"weighted", "sorted"}};

} // namespace

std::string_view nameOf(Translucency translucency) {
    return kNames.nameOf(translucency);
}

Translucency parseTranslucency(std::string_view name) {
    return kNames.parse(name);
}

} // namespace cdr::render
