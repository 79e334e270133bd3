#include "cdr_depth.hlsl"

// surface.vert of src/examples/host_compositing, for engines that write HLSL.
struct Push {
    CdrCascade cascade;
    float4 place;
    uint2 names;
};
[[vk::push_constant]] ConstantBuffer<Push> push;

struct Clipped {
    float4 position : SV_Position;
    [[vk::location(0)]] float ahead : AHEAD;
    float2 inside : SV_ClipDistance;
};

Clipped main(uint index : SV_VertexID) {
    float2 corner = float2((index & 1) == 0 ? -1.0 : 1.0, (index & 2) == 0 ? -1.0 : 1.0);
    Clipped clipped;
    clipped.ahead = push.place.z;
    clipped.position = cdrCascadePosition(push.place.xy + push.place.w * corner, clipped.ahead, push.cascade);
    clipped.inside = cdrInsideCascade(clipped.ahead, push.cascade);
    return clipped;
}
