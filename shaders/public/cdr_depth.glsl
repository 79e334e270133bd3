// Depth mappings for any engine. This file needs GLSL 3.30 or newer, or HLSL by cdr_depth.hlsl, and nothing else of cdr. cdr's
// own shaders use it. So the tests of cdr cover it. src/cdr/README.md shows how to use it, on the CPU and in a shader.
//
// What you do
// - On the CPU, in float64, per cascade: cdr::depth::cascadeConstants() gives the 32 bytes of CdrCascade.
// - On the CPU, in float64, per object and cascade: ahead0 = dot(forward, centre - eye) - anchorView, then round. That
//   subtraction is all there is to anchored depth; done in float32 on the GPU it would come too late.
// - In the vertex shader: ahead = ahead0 + the view distance of the rotated and scaled local vertex; then the functions
//   below. For mappings that are not anchored, anchorView is 0, so ahead is the view distance itself.
// - Depth range [0, 1] (Vulkan, Direct3D, Metal; glClipControl in OpenGL). Compare LESS_OR_EQUAL, clear to 1; reversed
//   mappings GREATER_OR_EQUAL, clear to 0. Not LESS: an exhausted buffer rounds to the clear value and draws nothing.
// - Depth clamp on, and cut by cdrInside() through gl_ClipDistance: clip z cannot cut a thin cascade exactly.
// - Cut meshes that are much wider than what they must resolve into pieces with origins of their own
//   (cdr::scene::cutIntoPieces()). float32 rounds a vertex by its distance to its origin.
//
// View space is right-handed and looks down -z; the view distance is w = -z. `projected` is view-space x and y times their
// entries of the projection matrix. Where y points down, these are 1 / (aspect tan(fovY / 2)) and -1 / tan(fovY / 2).
//
// @units Distances are view distances in scene units; `ahead` is one less anchorView. Depths are of the depth buffer, which a
//        clip position has as z / w.
// @range Finite numbers. Behind the camera and beyond a cascade's planes too: clip distances cut what lies there.
#ifndef CDR_DEPTH_GLSL
#define CDR_DEPTH_GLSL

// Rounded as written, so that pipelines agree to the bit. GLSL has no word for it before 4.00.
#ifndef CDR_PRECISE
#if __VERSION__ < 400
#define CDR_PRECISE
#else
#define CDR_PRECISE precise
#endif
#endif

// One cascade's cdr::depth::ClipTerms, rounded to float.
//   standard           anchorView 0      scale f/(f-n)   offset -fn/(f-n)
//   reversed           anchorView 0      scale -n/(f-n)  offset fn/(f-n)    no far plane: scale 0, offset n
//   log                anchorView 0      scale 1/n       offset 1/ln(f/n)
//   anchored           anchorView n      scale f/(f-n)   offset 0
//   anchored-reversed  anchorView f      scale -n/(f-n)  offset 0           ahead is negative
struct CdrDepth {
    float anchorView;
    float scale;
    float offset;
};

// Clip position under standard, reversed, anchored and anchored-reversed: one row of a projection matrix, so early depth
// tests and multisampling stay as they are.
vec4 cdrClipPosition(vec2 projected, float ahead, CdrDepth depth) {
    CDR_PRECISE vec4 position = vec4(projected, depth.scale * ahead + depth.offset, depth.anchorView + ahead);
    return position;
}

// Logarithmic depth in [0, 1] of a view distance, for gl_FragDepth or a vertex. A vertex behind the camera has no
// logarithm. Its triangle needs depth per fragment, where w is positive, and the clamp only keeps the value a number.
// @range distanceView: above 0 for a depth that means something; below 0 and above 1 beyond the cascade's planes.
float cdrLogDepth(float distanceView, CdrDepth depth) {
    return log(max(distanceView * depth.scale, 1e-30)) * depth.offset;
}

// Clip position under log, set per vertex. It is exact at vertices. Between them it is off by e^2 / 8 of the distance on a
// triangle that spans the share e of the distance.
// @range ahead: in front of the camera, as cdrLogDepth() says.
vec4 cdrClipPositionLog(vec2 projected, float ahead, CdrDepth depth) {
    CDR_PRECISE float distanceView = depth.anchorView + ahead;
    return vec4(projected, cdrLogDepth(distanceView, depth) * distanceView, distanceView);
}

// Clip position under log where the fragment shader sets the depth by cdrLogDepth(), moved into HostCascade::minDepth to
// maxDepth. It is the tangent of log depth at touchView (> 0, best the draw's own distance). It is linear in 1 / w, so on
// screen, and never above log depth, which is convex in 1 / w. Declare layout(depth_greater) out float gl_FragDepth, and
// devices that know it keep rejecting fragments before they are shaded.
// @range touchView: above 0.
vec4 cdrClipPositionLogTangent(vec2 projected, float ahead, float touchView, CdrDepth depth) {
    const float kMargin = 2e-6; // covers the roundings of both sides; those of logarithms grow with the offset of thin ranges
    float distanceView = depth.anchorView + ahead;
    float atTouch = cdrLogDepth(touchView, depth) - kMargin * max(depth.offset, 1.0);
    CDR_PRECISE vec4 position =
        vec4(projected, (atTouch + depth.offset) * distanceView - depth.offset * touchView, distanceView);
    return position;
}

// Signed distances to the near and far plane of a cascade, positive inside, for gl_ClipDistance[0] and [1].
// rangeAhead: the planes of cdr::depth::clipRange(), less anchorView, subtracted in float64; the nearer first.
vec2 cdrInside(float ahead, vec2 rangeAhead) {
    CDR_PRECISE vec2 inside = vec2(ahead - rangeAhead.x, rangeAhead.y - ahead);
    return inside;
}

// The same for wide draws: triangles many times longer than their distance, which clip distances cut inexactly. It cuts only
// what lies behind the camera. The fragment shader cuts the rest: it discards what cdrIsOutside() of its own `ahead`.
// distanceView: of the vertex. nearView: of the near plane.
// @range nearView: above 0.
vec2 cdrInFront(float distanceView, float nearView) { return vec2(distanceView - 0.5 * nearView, 1.0); }

// Whether a fragment of a wide draw is to be discarded. inside: cdrInside() of its own distance.
bool cdrIsOutside(vec2 inside) { return inside.x < 0.0 || inside.y < 0.0; }

// By how much a vertex' `ahead` may be off. float32 forms it from the vertex' place about the draw's origin and the distance
// of that origin. It differs from cascade to cascade, since the anchor does. Hand it to the fragments of wide draws.
// across: view space. originAhead: of the draw's origin.
float cdrRounding(vec2 across, float ahead, float originAhead, float anchorView) {
    const float kRoundings = 9.5367432e-7; // 2^-20: eight roundings of 2^-24 of all terms, in each of two cascades
    return kRoundings * (abs(across.x) + abs(across.y) + abs(ahead) + abs(originAhead) + abs(anchorView));
}

// cdrInside() of a fragment of a wide draw, for cascades that are drawn from far to near. Distances of two cascades differ by
// what they round, so each of two could leave a pixel to the other. So a cascade begins a little before its near plane. What
// it draws there has the depth of its near plane, and the nearer cascade draws over it. The nearest cascade has no other
// before it: do without this function there.
// inside: cdrInside() of the fragment. rounding: cdrRounding(), interpolated. distanceView: of the fragment.
vec2 cdrInsideWide(vec2 inside, float rounding, float distanceView) {
    const float kInterpolation = 0.0009765625; // 2^-10: what devices round between vertices, of the distance
    return vec2(inside.x + rounding + kInterpolation * distanceView, inside.y);
}

// One cascade: cdr::depth::CascadeConstants. Two vec4. So its 32 bytes are the same as push constants, in uniform and
// storage buffers, and in a constant buffer of HLSL.
struct CdrCascade {
    vec4 terms; // CdrDepth's anchorView, scale, offset; what the first leaves out of the float64 anchor
    vec4 range; // nearAhead, farAhead, and what view-space x and y are multiplied by
};

// The mapping of a cascade, for the functions above.
CdrDepth cdrDepthOf(CdrCascade cascade) {
    CdrDepth depth;
    depth.anchorView = cascade.terms.x;
    depth.scale = cascade.terms.y;
    depth.offset = cascade.terms.z;
    return depth;
}

// Clip position of a point by its view-space x and y and its distance beyond the anchor. For mappings without a logarithm.
// across: view space, not yet projected.
vec4 cdrCascadePosition(vec2 across, float ahead, CdrCascade cascade) {
    return cdrClipPosition(across * vec2(cascade.range.z, cascade.range.w), ahead, cdrDepthOf(cascade));
}

// cdrInside() of a cascade, for gl_ClipDistance[0] and [1].
vec2 cdrInsideCascade(float ahead, CdrCascade cascade) { return cdrInside(ahead, vec2(cascade.range.x, cascade.range.y)); }

// cdrInFront() of a cascade, for the vertex shader of a wide draw.
vec2 cdrInsideCascadeWide(float ahead, CdrCascade cascade) {
    return cdrInFront(cascade.terms.x + ahead, cascade.terms.x + cascade.range.x);
}

// For the fragment shader of a wide draw: discard where this holds of the interpolated distance.
bool cdrIsOutsideCascade(float ahead, CdrCascade cascade) { return cdrIsOutside(cdrInsideCascade(ahead, cascade)); }

// The same for cascades that are drawn from far to near, all but the nearest. cdrInsideWide() says why.
// ahead and rounding: interpolated; cdrRounding().
bool cdrIsOutsideCascadeWide(float ahead, float rounding, CdrCascade cascade) {
    return cdrIsOutside(cdrInsideWide(cdrInsideCascade(ahead, cascade), rounding, cascade.terms.x + ahead));
}

#endif
