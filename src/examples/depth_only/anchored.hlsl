// quoted in src/cdr/README.md: begin
#include "cdr_depth.hlsl"

[[vk::push_constant]] cbuffer Push { CdrCascade cascade; };

struct Vertex {
    float3 position : POSITION;       // about the mesh's own origin
    float3x3 turnAndScale : ROTATION; // object to view space, without translation; an attribute is a row
    float3 centre : CENTRE;           // view-space x and y, and the view distance beyond the anchor
};
struct Clipped {
    float4 position : SV_Position;
    float2 inside : SV_ClipDistance;
};

Clipped main(Vertex vertex) {
    float3 turned = mul(vertex.turnAndScale, vertex.position);
    float ahead = vertex.centre.z - turned.z;
    Clipped clipped;
    clipped.position = cdrCascadePosition(vertex.centre.xy + turned.xy, ahead, cascade);
    clipped.inside = cdrInsideCascade(ahead, cascade);
    return clipped;
}
// quoted in src/cdr/README.md: end
