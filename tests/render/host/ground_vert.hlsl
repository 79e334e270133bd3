#include "rectangle.hlsl"

// ground.vert, for engines that write HLSL.
Clipped main(uint index : SV_VertexID) {
    float x = (index & 1) == 0 ? -push.place.x : push.place.x;
    Clipped clipped;
    clipped.ahead = (index & 2) == 0 ? push.place.z : push.place.w;
    clipped.position = cdrCascadePosition(float2(x, push.place.y), clipped.ahead, push.cascade);
    clipped.inside = cdrInsideCascadeWide(clipped.ahead, push.cascade);
    return clipped;
}
