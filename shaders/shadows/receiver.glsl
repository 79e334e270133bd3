// A surface that may receive light.
#ifndef CDR_SHADERS_RECEIVER_GLSL
#define CDR_SHADERS_RECEIVER_GLSL

// The anchor plane is a float and its rest.
struct Receiver {
    vec2 anchor;
    float ahead;
    vec3 normal; // view space
};

// View distance.
float distanceOf(Receiver receiver) { return receiver.anchor.x + receiver.ahead; }

#endif
