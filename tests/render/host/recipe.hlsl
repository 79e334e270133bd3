#include "cdr_view.hlsl"

// recipe.comp, for engines that write HLSL.
struct Made {
    float4 pairAndLog;
    float4 straight, logarithmic, tangent;
    float4 inside;
};
[[vk::binding(0)]] StructuredBuffer<CdrCascade> cascades;
[[vk::binding(1)]] StructuredBuffer<float4> aheads;
[[vk::binding(2)]] RWStructuredBuffer<Made> made;

[numthreads(64, 1, 1)] void main(uint3 thread : SV_DispatchThreadID) {
    uint count, stride;
    aheads.GetDimensions(count, stride);
    if (thread.x >= count) {
        return;
    }
    float4 given = aheads[thread.x];
    float ahead = given.x;
    CdrCascade cascade = cascades[uint(given.y)];
    CdrDepth depth = cdrDepthOf(cascade);
    float2 across = float2(0.25, -0.5);
    float2 distanceView = cdrDistanceViewPair(ahead, cascade);
    float isOutside = cdrIsOutsideCascade(ahead, cascade) ? 1.0 : 0.0;
    Made result;
    result.pairAndLog = float4(distanceView, cdrLogDepth(distanceView.x, depth), isOutside);
    result.straight = cdrCascadePosition(across, ahead, cascade);
    result.logarithmic = cdrClipPositionLog(across, ahead, depth);
    result.tangent = cdrClipPositionLogTangent(across, ahead, given.z, depth);
    result.inside = float4(cdrInsideCascade(ahead, cascade), cdrInsideCascadeWide(ahead, cascade));
    made[thread.x] = result;
}
