#include <cdr/base/number_text.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/technique.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cdr::depth {

std::span<const NamedTechnique> presets() {
    static const std::vector<NamedTechnique> kPresets{
        {"standard", {.mapping = Mapping::standard, .split = SplitNone{}}},
        {"cdr", {.mapping = Mapping::standard, .split = SplitRatio{1000.0}}},
        {"log", {.mapping = Mapping::log, .split = SplitNone{}}},
        {"logcdr", {.mapping = Mapping::log, .split = SplitRatio{1000.0}}},
        {"reversed", {.mapping = Mapping::reversed, .split = SplitNone{}}},
        {"anchored", {.mapping = Mapping::anchored, .split = SplitFitted{}}},
    };
    return kPresets;
}

std::string nameOf(const Technique& technique) {
    const auto all = presets();
    const auto preset = std::find_if(all.begin(), all.end(), [&](const NamedTechnique& each) {
        return each.technique.mapping == technique.mapping && each.technique.split == technique.split;
    });
    return preset != all.end() ? preset->name : partsOf(technique);
}

std::string partsOf(const Technique& technique) {
    return base::concat(nameOf(technique.mapping), "/", nameOf(technique.split));
}

Technique parseTechnique(std::string_view name) {
    return tryParseTechnique(name).orThrow();
}

base::Result<Technique> tryParseTechnique(std::string_view name) {
    const base::Result<NamedTechnique> named = tryNamedTechnique(name);
    if (!named) {
        return named.refusal();
    }
    return named->technique;
}

NamedTechnique namedTechnique(std::string_view name) {
    return tryNamedTechnique(name).orThrow();
}

base::Result<NamedTechnique> tryNamedTechnique(std::string_view name) {
    std::vector<std::string_view> names;
    for (const NamedTechnique& preset : presets()) {
        if (preset.name == name) {
            return preset;
        }
        names.push_back(preset.name);
    }
    const std::size_t slash = name.find('/');
    if (slash == std::string_view::npos) {
        if (tryParseMapping(name)) {
            const std::string mapping(name);
            return base::Refusal{"technique '" + mapping + "' lacks a split, as in " + mapping + "/none"};
        }
        return base::Refusal{base::unknownName("technique", name, names)};
    }
    const auto mapping = tryParseMapping(name.substr(0, slash));
    if (!mapping) {
        return mapping.refusal();
    }
    const auto split = tryParseSplit(name.substr(slash + 1));
    if (!split) {
        return split.refusal();
    }
    const Technique technique{.mapping = *mapping, .split = *split};
    return NamedTechnique{partsOf(technique), technique};
}

} // namespace cdr::depth
