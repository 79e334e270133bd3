#include "cdr_depth.hlsl"

// ground.vert, for engines that write HLSL.
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
    float x = (index & 1) == 0 ? -push.place.x : push.place.x;
    Clipped clipped;
    clipped.ahead = (index & 2) == 0 ? push.place.z : push.place.w;
    clipped.position = cdrCascadePosition(float2(x, push.place.y), clipped.ahead, push.cascade);
    clipped.inside = cdrInsideCascadeWide(clipped.ahead, push.cascade);
    return clipped;
}
