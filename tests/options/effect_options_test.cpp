#include "parsing.h"

#include <gtest/gtest.h>
#include <options/effect_options.h>

namespace cdr::options {

namespace {

struct Finished {
    render::RenderOptions options;
    scene::GltfChoice choice;
};

/// What the words make of the options, or why they do not.
std::string parseEffects(const std::vector<std::string>& words, Finished& finished) {
    CLI::App command;
    addEffectOptions(command, finished.options, finished.choice);
    return refusalOf(command, words);
}

TEST(EffectOptions, GoIntoARenderersOptions) {
    Finished finished;
    EXPECT_EQ(
        parseEffects({"--antialias=edges", "--occlusion=2:layers", "--fog=10,1,0,0.5", "--tone-map=neutral",
                      "--exposure=-2", "--light=file", "--focus=10:0.5:blend", "--shadows=plain",
                      "--shadow-texels=128", "--translucency=sorted", "--translucency-memory=3"},
                     finished),
        "");
    const render::Effects effects{.antialias = render::Antialias::edges,
                                  .occlusion = {.radius = 2.0, .perLayer = true},
                                  .fog = {.visibility = 10.0, .color = {1.0f, 0.0f, 0.5f}},
                                  .finish = {.toneMap = render::ToneMap::neutral, .exposure = -2.0}};
    EXPECT_EQ(finished.options.effects, effects);
    EXPECT_EQ(finished.options.focus, (render::Focus{.distance = 10.0, .aperture = 0.5, .blend = true}));
    EXPECT_EQ(finished.options.shadows,
              (render::Shadows{.method = render::ShadowMethod::plain, .maxTexels = 128}));
    EXPECT_EQ(finished.options.translucency.method, render::Translucency::sorted);
    EXPECT_EQ(finished.options.translucency.maxBytes, std::uint64_t{3} << 20u);
    EXPECT_EQ(finished.choice.light, scene::ModelLight::file);
}

TEST(EffectOptions, AreNoneUnlessGiven) {
    Finished finished;
    EXPECT_EQ(parseEffects({"--focus", "", "--fog", "", "--occlusion", "", "--light", ""}, finished), "");
    EXPECT_EQ(finished.options, render::RenderOptions{});
    EXPECT_EQ(finished.choice, scene::GltfChoice{});
}

TEST(EffectOptions, RefuseWhatCannotBeDrawn) {
    for (const char* word :
         {"--fog=10,1", "--fog=10,1,2,0", "--fog=-1", "--occlusion=1:layer", "--occlusion=-1", "--focus=10",
          "--focus=10:-1", "--focus=10:1:blnd", "--exposure=nan", "--exposure=17", "--shadow-texels=1",
          "--tone-map=sene", "--translucency-memory=0"}) {
        Finished finished;
        const std::string refusal = parseEffects({word}, finished);
        EXPECT_FALSE(refusal.empty()) << word;
        EXPECT_EQ(refusal.find('\n'), std::string::npos) << word;
    }
}

} // namespace

} // namespace cdr::options
