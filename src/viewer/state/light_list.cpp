#include "light_list.h"

#include "plain_words.h"

#include <cdr/base/enum_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace cdr::viewer {

namespace {

constexpr std::size_t kMaxLines = 12;
constexpr base::EnumNames<scene::LightType, 3> kTypeNames{"light",
                                                          {"point light", "directional light", "spot light"}};

} // namespace

std::vector<std::string> lightLines(std::span<const scene::ListedLight> lights) {
    std::vector<std::string> lines;
    for (const scene::ListedLight& light : lights.first(std::min(lights.size(), kMaxLines))) {
        lines.push_back(fmt::format("{}{}{}", kTypeNames.nameOf(light.type),
                                    light.name.empty() ? "" : " '" + light.name + "'",
                                    light.moves ? ", moves" : ""));
    }
    if (lights.size() > kMaxLines) {
        lines.push_back("and " + counted(lights.size() - kMaxLines, "more light"));
    }
    return lines;
}

} // namespace cdr::viewer
