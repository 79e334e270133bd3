#include <cdr/gpu/pipeline.h>
#include <cdr/shaders/geometry.h>
#include <cdr/shaders/output.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/shadows.h>
#include <cdr/shaders/translucency.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace cdr::render {

namespace {

// The numbers are those of the SPIR-V specification.
constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kOpName = 5;
constexpr std::uint32_t kOpFunction = 54;
constexpr std::uint32_t kOpFunctionEnd = 56;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kOpFAdd = 129;
constexpr std::uint32_t kOpFSub = 131;
constexpr std::uint32_t kNoContraction = 42;

struct Sums {
    std::size_t kept = 0;       ///< additions and subtractions that a driver rounds as they are written
    std::size_t contracted = 0; ///< those that it may fuse with a multiplication
};

/// Of all functions of that name.
Sums sumsIn(const gpu::Spirv& spirv, const std::string& function) {
    const std::span<const std::uint32_t> words(spirv.words);
    std::set<std::uint32_t> named;
    std::set<std::uint32_t> kept;
    bool isInside = false;
    Sums sums;
    for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16u) {
        switch (words[at] & 0xFFFFu) {
        case kOpName: {
            // glslang names a function "name(types;", except for the first, which is "main".
            const std::string name(reinterpret_cast<const char*>(&words[at + 2]));
            if (name == function || name.starts_with(function + "(")) {
                named.insert(words[at + 1]);
            }
            break;
        }
        case kOpDecorate:
            if (words[at + 2] == kNoContraction) {
                kept.insert(words[at + 1]);
            }
            break;
        case kOpFunction:
            isInside = named.contains(words[at + 2]);
            break;
        case kOpFunctionEnd:
            isInside = false;
            break;
        case kOpFAdd:
        case kOpFSub:
            if (isInside) {
                ++(kept.contains(words[at + 2]) ? sums.kept : sums.contracted);
            }
            break;
        default:
            break;
        }
    }
    return sums;
}

struct Case {
    std::string name;
    gpu::Spirv spirv;
    std::string function;
    std::size_t sums;
};

/// Where a fused multiplication would round otherwise than another shader does, or than the bound of roundings says.
TEST(PreciseDistances, SmallDifferencesOfLargeOnesAreRoundedAsWritten) {
    const std::vector<Case> cases{
        {"shading", kShadingFrag, "wayTo", 7},
        {"shading, shadowed", kShadingShadowedFrag, "wayTo", 7},
        {"weighted translucency", kTranslucentWeightedFrag, "wayTo", 7},
        {"sorted translucency, shadowed", kTranslucentSortedShadowedFrag, "wayTo", 7},
        {"shading, occluded", kShadingOccludedFrag, "distanceBetween", 5},
        {"receivers", kReceiverFrag, "beyondReference", 3},
        {"receivers", kReceiverFrag, "texelsAt", 1},
        {"receivers", kReceiverFrag, "texelsBefore", 1},
        {"receivers", kReceiverFrag, "depthPerTexel", 1},
        {"receivers of facets", kReceiverFacetsFrag, "beyondReference", 3},
        {"receivers of facets", kReceiverFacetsFrag, "texelsAt", 1},
        {"receivers of facets", kReceiverFacetsFrag, "texelsBefore", 1},
        {"translucent receivers", kTranslucentSortedShadowedFrag, "beyondReference", 3},
        {"translucent receivers", kTranslucentSortedShadowedFrag, "texelsAt", 1},
        {"translucent receivers", kTranslucentSortedShadowedFrag, "texelsBefore", 1},
        {"casters", kCasterVert, "main", 6},
        {"geometry", kGeometryVert, "main", 4},
        {"geometry", kGeometryVert, "projectedOf", 2},
        {"geometry", kGeometryVert, "cdrClipPosition", 2},
        {"geometry", kGeometryVert, "cdrClipPositionLog", 1},
        {"geometry", kGeometryVert, "cdrClipPositionLogTangent", 4},
        {"geometry", kGeometryVert, "cdrInside", 2},
        {"geometry of facets", kGeometryFacetedVert, "main", 4},
        {"geometry, pushed", kGeometryPushedVert, "main", 4},
        {"facets", kFacetVert, "cdrClipPosition", 2},
        {"facets", kFacetVert, "cdrInside", 2},
        {"translucent surfaces", kTranslucentVert, "main", 6},
        {"translucent surfaces with detail", kTranslucentDetailedVert, "main", 6},
        {"sorted translucency", kTranslucentSortedFrag, "cdrExactSum", 6},
        {"sorted translucency", kTranslucentSortedFrag, "cdrPairSum", 1},
        {"motion", kOutputMotionFrag, "cdrExactSum", 6},
        {"motion", kOutputMotionFrag, "cdrUpperHalf", 2},
        {"motion", kOutputMotionFrag, "cdrExactProduct", 6},
        {"motion of deformed meshes", kOutputDeformedMotionVert, "main", 5},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name + ": " + each.function);
        const Sums sums = sumsIn(each.spirv, each.function);
        EXPECT_EQ(sums.contracted, 0u);
        EXPECT_EQ(sums.kept, each.sums);
    }
}

} // namespace

} // namespace cdr::render
