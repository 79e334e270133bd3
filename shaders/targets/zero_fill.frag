#version 460

// Background of a G-buffer.
layout(location = 0) out uvec4 outTexel;

void main() { outTexel = uvec4(0u); }
