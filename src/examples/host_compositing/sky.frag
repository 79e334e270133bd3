#version 460

// What the host draws over the finished picture, by its own depth test.
layout(location = 0) out vec4 color;

void main() { color = vec4(0.2, 0.3, 0.5, 1.0); }
