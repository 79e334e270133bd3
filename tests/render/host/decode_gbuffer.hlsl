#include "cdr_gbuffer.hlsl"

// decode_gbuffer.comp, for engines that write HLSL.
[[vk::binding(0)]] Texture2D<uint4> gbuffer;
[[vk::binding(1)]] RWStructuredBuffer<float4> decoded;
struct Push {
    float4 anchors[8];
};
[[vk::push_constant]] ConstantBuffer<Push> push;

[numthreads(8, 8, 1)] void main(uint3 thread : SV_DispatchThreadID) {
    uint2 size;
    gbuffer.GetDimensions(size.x, size.y);
    if (thread.x >= size.x || thread.y >= size.y) {
        return;
    }
    uint4 texel = gbuffer.Load(int3(thread.xy, 0));
    uint cascade = cdrCascadeOf(texel);
    float3 normal = cdrNormalOf(texel);
    float3 albedo = cdrAlbedoOf(texel);
    uint4 again = cdrGBufferTexel(albedo, normal, cdrAheadOf(texel), cdrIdOf(texel), cascade);
    float2 distanceView = cdrDistanceViewOf(texel, push.anchors[cascade].xy);
    uint first = 3u * (thread.y * size.x + thread.x);
    decoded[first] = float4(distanceView, float(cdrIdOf(texel)), float(cascade));
    decoded[first + 1u] = float4(normal, float(again.w == texel.w && again.z == texel.z));
    decoded[first + 2u] = float4(albedo, float(again.x == (texel.x & 0xffffffu)));
}
