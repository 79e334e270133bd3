#include <cdr/base/error.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/technique.h>
#include <cdr/visibility/level_choice.h>

#include <options/layer_text.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

/// What parses is written as a text that parses to the same.
template <typename Parse, typename Name>
void checkWord(std::string_view text, const Parse& parse, const Name& name) {
    try {
        const auto value = parse(text);
        if (!(parse(name(value)) == value)) {
            __builtin_trap();
        }
    } catch (const cdr::base::InputError&) {
    }
}

/// A split of any numbers ends in cascades or is refused.
void cut(std::string_view text) {
    try {
        const cdr::depth::SplitContext context{.nearView = 0.1, .farView = 1e5, .footprintSlope = 1e-3};
        if (makeCascades(cdr::depth::parseSplit(text), context).size() > cdr::depth::kMaxCascades) {
            __builtin_trap();
        }
    } catch (const cdr::base::InputError&) {
    }
}

} // namespace

/// Any word of an option is taken, or refused with base::InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    namespace depth = cdr::depth;
    namespace visibility = cdr::visibility;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    checkWord(text, depth::parseSplit, [](const depth::Split& split) { return nameOf(split); });
    checkWord(text, depth::parseMapping, [](depth::Mapping mapping) { return nameOf(mapping); });
    checkWord(text, depth::parseDepthFormat, [](depth::DepthFormat format) { return nameOf(format); });
    checkWord(text, depth::parseTechnique,
              [](const depth::Technique& technique) { return partsOf(technique); });
    checkWord(text, visibility::parseDetail, [](const visibility::Detail& detail) { return nameOf(detail); });
    checkWord(text, cdr::options::parseLayer,
              [](const cdr::scenes::LayerChoice& choice) { return cdr::options::textOf(choice); });
    cut(text);
    return 0;
}
