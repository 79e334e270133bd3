#version 460

// What is drawn shows its number.
layout(push_constant) uniform Push { layout(offset = 32) uint id; };
layout(location = 0) out uint shown;

void main() { shown = id; }
