#include "../support/refusal.h"

#include <gtest/gtest.h>
#include <options/layer_text.h>

#include <limits>
#include <string>

namespace cdr::options {

namespace {

using scenes::LayerChoice;

std::string layerRefusalOf(const std::string& text) {
    return test::inputErrorOf([&] { parseLayer(text); });
}

TEST(LayerText, ReadsWhatItWrites) {
    for (const LayerChoice& choice :
         {LayerChoice{"paint", 0.002f}, LayerChoice{"a=b", -3.0f}, LayerChoice{"#7", 0.0f},
          LayerChoice{"name with blanks", std::numeric_limits<float>::min()},
          LayerChoice{"=", std::numeric_limits<float>::lowest()}}) {
        EXPECT_EQ(parseLayer(textOf(choice)), choice) << textOf(choice);
    }
}

TEST(LayerText, RefusesInOneLine) {
    for (const char* text : {"", "=", "paint", "=0.1", "paint=", "paint=x", "paint=nan", "paint=inf",
                             "paint=1e39", "paint=-1e300", "paint=0.1m", "paint=1e-320", "paint=-1.17e-38"}) {
        const std::string refusal = layerRefusalOf(text);
        EXPECT_NE(refusal.find("layer"), std::string::npos) << text << ": " << refusal;
        EXPECT_EQ(refusal.find('\n'), std::string::npos) << text;
    }
}

} // namespace

} // namespace cdr::options
