#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/technique.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::depth {

std::span<const Technique> presets() {
    static const std::vector<Technique> kPresets{
        {.name = "standard", .mapping = Mapping::standard, .split = SplitNone{}},
        {.name = "cdr", .mapping = Mapping::standard, .split = SplitRatio{1000.0}},
        {.name = "log", .mapping = Mapping::log, .split = SplitNone{}},
        {.name = "logcdr", .mapping = Mapping::log, .split = SplitRatio{1000.0}},
        {.name = "reversed", .mapping = Mapping::reversed, .split = SplitNone{}},
        {.name = "anchored", .mapping = Mapping::anchored, .split = SplitFitted{}},
    };
    return kPresets;
}

Technique parseTechnique(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Technique& preset : presets()) {
        if (preset.name == name) {
            return preset;
        }
        names.push_back(preset.name);
    }
    if (const std::size_t slash = name.find('/'); slash != std::string_view::npos) {
        return makeTechnique(parseMapping(name.substr(0, slash)),
                             parseSplit(std::string(name.substr(slash + 1))), DepthFormat::d32f);
    }
    throw base::InputError(base::unknownName("technique", name, names));
}

Technique makeTechnique(Mapping mapping, Split split, DepthFormat format) {
    std::string name = fmt::format("{}/{}", nameOf(mapping), nameOf(split));
    return {.name = std::move(name), .mapping = mapping, .split = std::move(split), .format = format};
}

} // namespace cdr::depth
