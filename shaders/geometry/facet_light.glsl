// What facets that are lit while they are drawn hand from facet.vert to facet.frag. Define LIGHTS, their number.
#ifndef CDR_SHADERS_FACET_LIGHT_GLSL
#define CDR_SHADERS_FACET_LIGHT_GLSL

const int kAmbientLocation = 2;   // light from all around that the facet reflects
const int kReflectedLocation = 3; // of each light: its colour times albedo and height over the facet; 1 / half distance^2
const int kWayLocation = 3 + LIGHTS; // from the surface to each light, view space

#endif
