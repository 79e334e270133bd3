#include "rectangle.hlsl"
#include "cdr_gbuffer.hlsl"

// ground.frag, for engines that write HLSL.
uint4 main([[vk::location(0)]] float ahead : AHEAD) : SV_Target0 {
    if (cdrIsOutsideCascade(ahead, push.cascade)) {
        discard;
    }
    return cdrGBufferTexel(float3(0.4, 0.6, 0.2), float3(0.0, 1.0, 0.0), ahead, push.names.y, push.names.x);
}
