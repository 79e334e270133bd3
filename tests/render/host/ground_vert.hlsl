#include "rectangle.hlsl"

// ground.vert, for engines that write HLSL.
Clipped main(uint index : SV_VertexID, [[vk::location(1)]] out float rounding : ROUNDING) {
    float x = (index & 1) == 0 ? -push.place.x : push.place.x;
    Clipped clipped;
    clipped.ahead = (index & 2) == 0 ? push.place.z : push.place.w;
    rounding = cdrRounding(float2(x, push.place.y), clipped.ahead, 0.0, push.cascade.terms.x);
    clipped.position = cdrCascadePosition(float2(x, push.place.y), clipped.ahead, push.cascade);
    clipped.inside = cdrInsideCascadeWide(clipped.ahead, push.cascade);
    return clipped;
}
