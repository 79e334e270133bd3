// Constants and struct layouts that C++ and GLSL share. Every struct is laid out the same by std430 and by
// C++.
#ifndef CDR_SHADERS_SHARED_H
#define CDR_SHADERS_SHARED_H

#include "sharing.h"

CDR_SHARED_BEGIN

// How the vertex shader forms clip z; specialisation constant 0.
CDR_CONST kDepthFormLinear = 0u;      // one row of a projection matrix: standard, reversed, anchored
CDR_CONST kDepthFormLog = 1u;         // logarithm per vertex
CDR_CONST kDepthFormLogFragment = 2u; // logarithm per fragment

// The id word holds the object index plus one in its low bits, the cascade above, and a flag; 0 is
// background.
CDR_CONST kIdBits = 24u;
CDR_CONST kIdMask = 0xffffffu;
CDR_CONST kCascadeMask = 0x3fu; // after a shift by kIdBits
CDR_CONST kIdUnlit = 0x80000000u;
CDR_CONST kIdEmits = 0x40000000u;  // of a pixel: the emission buffer holds something of it
CDR_CONST kIdMirror = 0x40000000u; // of a draw: its basis turns inside out

// What a material has beside base colour, metallic and roughness; sums of these are a specialisation constant of pipelines.
CDR_CONST kDetailMetallicRoughness = 1u; // a texture of metallic and roughness
CDR_CONST kDetailNormal = 2u;            // a normal texture
CDR_CONST kDetailOcclusion = 4u;         // an occlusion texture
CDR_CONST kDetailEmissive = 8u;          // an emissive texture
CDR_CONST kDetailEmits = 16u;            // it emits light, textured or not
CDR_CONST kDetailMoved = 32u;            // some of its textures are read elsewhere than at a vertex' places
CDR_CONST kDetailShared =
    64u; // occlusion is the red of the texture of metallic and roughness, at the same place
CDR_CONST kDetailPacked =
    128u; // alpha of the base colour's texture is occlusion, of the normal texture metallic, of the emissive one roughness
CDR_CONST kDetailMasks = 256u; // how many sums there are

// Textures of a material's detail: those of the first parts above, in their order.
CDR_CONST kDetailTextures = 4u;

// Metallic and roughness in one byte: 0 is matt, else 1 + metallic * kRoughnessSteps + roughness, both as
// steps of their range [0, 1]. Roughness is kept in fiftieths, since highlights show it; metallic in
// quarters, since most materials are all metal or none.
CDR_CONST kMetallicSteps = 5u;
CDR_CONST kRoughnessSteps = 51u;
CDR_CONST kMetallicRoughnessMask = 0xffu;

// What is done to lit colours on their way to the picture.
CDR_CONST kFinishNone = 0u;
CDR_CONST kFinishExposed = 1u; // times an exposure
CDR_CONST kFinishNeutral = 2u; // times an exposure, then tone mapping by Khronos PBR Neutral
CDR_CONST kFinishLater = 3u;   // a later step finishes; half floats hold the colours until then

// Most cascades, depth::kMaxCascades.
CDR_CONST kCascadeSlots = 64u;

// Lights that cast shadows: the channels of the mask that says which of them reach a surface. scene::kMaxShadowLights.
CDR_CONST kShadowChannels = 4u;

// A material's detail, in a uniform buffer.
struct DetailRecord {
    vec4 emissionAndNormalScale;        // linear emission; the normal texture's scale
    vec4 metallicRoughnessAndOcclusion; // metallic, roughness, occlusion strength; unused
    uint
        secondPlaces; // of which textures, as a sum of the above, a vertex' second place in textures is meant
    uint unused0;
    uint unused1;
    uint unused2;
    vec4 turns[kDetailTextures];   // with kDetailMoved, by texture: what steps of u and v of a place add
    vec4 offsets[kDetailTextures]; // and what is added to that; the rest is 0
};

// One draw: object to view space, relative to the cascade's anchor plane. 64 bytes, one cache line.
struct DrawRecord {
    vec4 right; // row of (view * basis) in xyz, translation in w: view-space x
    vec4 up;    // the same for view-space y
    vec4 ahead; // the same for the view distance beyond the anchor: w - anchorView, formed in float64
    uint id;    // object index + 1, kIdUnlit and kIdMirror
    uint
        cutoffAndMetallicRoughness; // the bits of a float, its lowest byte replaced by metallic and roughness (kMetallicRoughnessMask)
    uint baseColorRg; // linear base colour factor as four halves
    uint baseColorBa;
};

// What a cascade's draws share; push constants.
struct CascadePush {
    float anchorView; // depth::ClipTerms, rounded
    float depthScale;
    float depthOffset;
    float nearAhead; // the clip range, relative to the anchor plane
    float farAhead;
    float projectionX; // 1 / (aspect * tan(fovY / 2))
    float projectionY; // -1 / tan(fovY / 2): Vulkan's y points down
    uint cascade;
    float minDepth; // the slice of the depth range the cascade draws in, as its viewport has it
    float maxDepth;
    float layerOffset; // scene::Material::layer of the draws
    float layerRank;   // render::LayerPlace::rank
    float lensX; // of a lens that is shifted: what a clip position's x and y have less, in units of its w
    float lensY;
};

// Where a draw record lies in push constants, after the cascade's: for draws that bring their record along.
CDR_CONST kPushedRecordOffset = 64u;

// A corner of a facet as it is drawn: the visibility path's vertices come transformed.
struct FacetVertex {
    float x; // view space
    float y;
    float ahead; // view distance beyond the anchor plane
    uint facet;  // of the triangles that start with it: 1 + the index of its FacetRecord
};

// Most lights by which facets are lit while they are drawn. Each of them takes two varyings, and a software rasteriser pays for
// every varying of every triangle.
CDR_CONST kPushedLights = 2u;
// Where these lights lie in push constants, after the cascade's. Each has view-space x and y, the view distance beyond the
// cascade's anchor plane, and 1 / half distance^2.
CDR_CONST kPushedLightsOffset = 64u;

// A facet that a visibility buffer refers to: what shading needs of its surface. Two texels of four uints.
struct FacetRecord {
    vec2 normal;  // view space, octahedral
    float extent; // the distance beyond the anchor differs from `ahead` by no more on the facet
    uint albedo;  // as the G-buffer has it (gbuffer.glsl)
    float x;      // a point of its plane, view space
    float y;
    float ahead; // of that point, beyond the anchor plane
    uint id;     // as the G-buffer has it
};

// A point light in view space; every coordinate is a float and the rest that float left out of the float64.
struct LightRecord {
    vec4 position;     // x, y, view distance; 1 / half distance^2
    vec4 positionRest; // the rest of x, y and view distance; 1 / range^2, 0 without a range
    vec4 color;        // linear; 1 if it has a cone or a range, else 0
    vec4
        beam; // of a cone: the way it shines, x, y and z of view space, times a scale; an offset. Else 0, 0, 0, 1
};

// Up to this many lights reach the fragments of the shading pass as flat varyings. With what the header hands over, they
// fill the 64 components that every device has. More are read from the buffer.
CDR_CONST kFlatLights = 4u;
// What the shading pass is told in the place of a number of lights. The first is for more than these. The second is for any
// number of which some have a cone or a range. Flat varyings have no room for either.
CDR_CONST kManyLights = 5u;
CDR_CONST kShapedLights = 6u;

// What merging needs of a layer to work out its ambient occlusion; push constants.
struct LayerPush {
    vec2 rayScale; // as ShadingHeader has it
    float anchorView;
    float radius;
    vec2 rayCentre;
};

// How many pixels the picture has that layers of other sizes are scaled to; push constants.
struct PictureSize {
    vec2 pixels;
};

// The depth of a host's camera: scale + offset / view distance; push constants.
struct HostDepthPush {
    float scale;
    float offset;
    float background; // what the host clears to
};

// How a layer's surfaces fade out with their distance; push constants. All zero: not at all.
struct LayerFade {
    float beginAhead; // beyond the cascade's anchor plane
    float perUnit;    // of distance
};

// scene::Air as a camera sees it. Lengths are in radii of the planet, which is a sphere once everything is stretched along its
// axis. Directions are in view space.
struct AirRecord {
    vec4 up;        // stretched, unit: from the planet's centre to the camera; the camera's height
    vec4 axis;      // times the root of how much is added along it; 1 / radius in scene units
    vec4 toSun;     // stretched, unit; the height over which there is no air
    vec4 molecules; // scattering per radius; the height by which they get thinner
    vec4 haze;      // the same
    vec4 sunlight;  // linear; how much haze scatters ahead
};

// What the shading pass needs, followed by the lights.
struct ShadingHeader {
    vec3 ambient;
    uint lightCount;
    vec3 background; // linear colour: that of the fog, or else the one shown
    float occlusionRadius;
    vec2 rayScale; // view-space x and y per unit of view distance at the right and top edges of the picture
    vec2 pictureSize; // in pixels
    vec2 rayCentre;   // view-space x and y per unit of view distance at the middle of the picture
    vec2 unused;
    // Linear colour that is written where no surface is; in a scene with air, that behind the air.
    vec4 shownBackground;
    vec4 fog;       // linear colour, and what it takes per unit of distance
    vec4 skyUp;     // view space, unit; of the sky the rest
    vec4 skyZenith; // linear radiance
    vec4 skyHorizon;
    vec4 skyGround;
    AirRecord air;
    vec2 anchors[kCascadeSlots]; // each cascade's anchor plane as a float and its rest
};

static_assert(kMetallicSteps * kRoughnessSteps <= kMetallicRoughnessMask);
static_assert(sizeof(DrawRecord) == 64);
static_assert(sizeof(CascadePush) == 56);
static_assert(kPushedRecordOffset % 16 == 0 && kPushedRecordOffset >= sizeof(CascadePush));
static_assert(kPushedRecordOffset + sizeof(DrawRecord) <= 128); // what every device has
static_assert(sizeof(FacetVertex) == 16);
static_assert(sizeof(FacetRecord) == 32);
static_assert(sizeof(LightRecord) == 64);
static_assert(kManyLights == kFlatLights + 1 && kShapedLights == kFlatLights + 2);
static_assert(sizeof(LayerPush) == 24);
static_assert(sizeof(ShadingHeader) == 256 + 8 * kCascadeSlots);
static_assert(sizeof(DetailRecord) == 48 + 32 * kDetailTextures);

CDR_SHARED_END

#endif
