// Each pixel's translucent fragments as a linked list; define CDR_LIST_SET before.
#ifndef CDR_SHADERS_FRAGMENT_LIST_GLSL
#define CDR_SHADERS_FRAGMENT_LIST_GLSL

#include "translucency/translucent_shared.h"

layout(set = CDR_LIST_SET, binding = 0, std430) buffer Heads { uint heads[]; }; // by pixel, row by row
layout(set = CDR_LIST_SET, binding = 1, std430) buffer Nodes { FragmentNode nodes[]; };
// Fragments there were, even those that found no room; at most kMostCounted.
layout(set = CDR_LIST_SET, binding = 2, std430) buffer Count { uint fragmentCount; };

#endif
