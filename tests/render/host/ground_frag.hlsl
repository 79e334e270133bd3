#include "cdr_depth.hlsl"
#include "cdr_gbuffer.hlsl"

// ground.frag, for engines that write HLSL.
struct Push {
    CdrCascade cascade;
    float4 place;
    uint2 names;
};
[[vk::push_constant]] ConstantBuffer<Push> push;

uint4 main([[vk::location(0)]] float ahead : AHEAD) : SV_Target0 {
    if (cdrIsOutsideCascade(ahead, push.cascade)) {
        discard;
    }
    return cdrGBufferTexel(float3(0.4, 0.6, 0.2), float3(0.0, 1.0, 0.0), ahead, push.names.y, push.names.x);
}
