#include "cdr_depth.hlsl"

// What rectangles of a host's share: push constants as HostRectangles fills them, and what their vertices hand on.
struct Push {
    CdrCascade cascade;
    float4 place;
    uint2 names; // the cascade's index; the object's index + 1
};
[[vk::push_constant]] ConstantBuffer<Push> push;

struct Clipped {
    float4 position : SV_Position;
    [[vk::location(0)]] float ahead : AHEAD;
    float2 inside : SV_ClipDistance;
};
