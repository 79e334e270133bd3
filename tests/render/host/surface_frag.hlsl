#include "rectangle.hlsl"
#include "cdr_gbuffer.hlsl"

// surface.frag of src/examples/host_compositing, for engines that write HLSL.
uint4 main([[vk::location(0)]] float ahead : AHEAD) : SV_Target0 {
    return cdrGBufferTexel(float3(0.1, 0.4, 0.8), float3(0.0, 0.0, 1.0), ahead, push.names.y, push.names.x);
}
