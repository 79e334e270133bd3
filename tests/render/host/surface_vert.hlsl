#include "rectangle.hlsl"

// surface.vert of src/examples/host_compositing, for engines that write HLSL.
Clipped main(uint index : SV_VertexID) {
    float2 corner = float2((index & 1) == 0 ? -1.0 : 1.0, (index & 2) == 0 ? -1.0 : 1.0);
    Clipped clipped;
    clipped.ahead = push.place.z;
    clipped.position = cdrCascadePosition(push.place.xy + push.place.w * corner, clipped.ahead, push.cascade);
    clipped.inside = cdrInsideCascade(clipped.ahead, push.cascade);
    return clipped;
}
