#include <cdr/base/enum_names.h>
#include <cdr/render/shadows/shadows.h>

namespace cdr::render {

namespace {

constexpr base::EnumNames<ShadowMethod, kShadowMethods.size()> kMethodNames{"shadows",
                                                                            {"none", "anchored", "plain"}};

} // namespace

std::string_view nameOf(ShadowMethod method) {
    return kMethodNames.nameOf(method);
}

ShadowMethod parseShadowMethod(std::string_view name) {
    return kMethodNames.parse(name);
}

} // namespace cdr::render
