#include "rectangle.hlsl"
#include "cdr_gbuffer.hlsl"

// ground.frag, for engines that write HLSL.
uint4 main([[vk::location(0)]] float ahead : AHEAD, [[vk::location(1)]] float rounding : ROUNDING) : SV_Target0 {
    bool isNearest = push.names.x == 0;
    if (isNearest ? cdrIsOutsideCascade(ahead, push.cascade)
                  : cdrIsOutsideCascadeWide(ahead, rounding, push.cascade)) {
        discard;
    }
    return cdrGBufferTexel(float3(0.4, 0.6, 0.2), float3(0.0, 1.0, 0.0), ahead, push.names.y, push.names.x);
}
