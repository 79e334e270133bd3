#include "cdr_in_plane.hlsl"
#include "cdr_view.hlsl"

// recipe.comp, for engines that write HLSL.
struct Made {
    float4 pairAndLog;
    float4 straight, logarithmic, tangent;
    float4 inside;
    float4 inPlane;
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
    float3 place = float3(given.w * distanceView.x, -0.5 * distanceView.x, ahead);
    float2 perSlope = cascade.range.zw * 1e4;
    float3 moved = cdrInPlane(place, float3(0.75, 0.5, 1.0), perSlope, 0.01 * distanceView.x, cascade.terms.x);
    float3 stays = cdrInPlane(place, float3(0.75, 0.5, 1.0), perSlope, 0.0, cascade.terms.x);
    result.inPlane = float4(moved, stays.z == ahead ? 1.0 : 0.0);
    made[thread.x] = result;
}
