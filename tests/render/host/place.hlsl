#include "cdr_view.hlsl"

// place.comp, for engines that write HLSL.
struct Camera {
    CdrView view;
    CdrCascade cascade;
};
struct Place {
    float4 at, rest;
};
[[vk::binding(0)]] StructuredBuffer<Camera> camera;
[[vk::binding(1)]] StructuredBuffer<Place> places;
[[vk::binding(2)]] RWStructuredBuffer<float4> seen;

[numthreads(64, 1, 1)] void main(uint3 thread : SV_DispatchThreadID) {
    uint count, stride;
    places.GetDimensions(count, stride);
    if (thread.x < count) {
        Place place = places[thread.x];
        seen[thread.x] = float4(cdrPlace(place.at.xyz, place.rest.xyz, camera[0].view, camera[0].cascade), 0.0);
    }
}
