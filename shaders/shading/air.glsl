// What air around a planet does to what is seen through it (scene::Air): sunlight that is scattered once. Lengths are in radii of
// the planet, which is a sphere of radius 1 once rays are stretched along its axis. Heights come from products of small lengths,
// not from differences of squares, so float32 resolves a metre on an Earth. Define nothing; include after shared.h.
#ifndef CDR_SHADERS_AIR_GLSL
#define CDR_SHADERS_AIR_GLSL

// On each side of the lowest place of a ray.
const int kAirSteps = 8;
const float kHalfPi = 1.5707963;

struct AirSeen {
    vec3 passed; // the share of light that comes through
    vec3 added;
};

// A straight way, of which `lowest` is the height of the place at `nearest`; both are also meant where the way does not reach.
struct AirWay {
    float eyeHeight;
    float nearest;
    float lowest;
};

AirWay airWay(float eyeHeight, float climb) {
    float eye = 1.0 + eyeHeight;
    float nearest = -eye * climb;
    float nearestRadius = sqrt(max(eye * eye - nearest * nearest, 0.0));
    return AirWay(eyeHeight, nearest, eyeHeight - nearest * nearest / max(nearestRadius + eye, 1e-20));
}

float airHeightAt(AirWay way, float along) {
    float eye = 1.0 + way.eyeHeight;
    float squares = along * (along - 2.0 * way.nearest);
    return way.eyeHeight + squares / max(sqrt(max(eye * eye + squares, 0.0)) + eye, 1e-20);
}

// From the place nearest to the centre to that of a height above it.
float airReach(AirWay way, float height) {
    return sqrt(max((height - way.lowest) * (2.0 + height + way.lowest), 0.0));
}

// How much air of a part of the air lies towards the Sun. Chapman's function by the scaled complementary error function, for which
// stands a fit within 0.2 % of it, between bounds of Abramowitz and Stegun (7.1.13).
float airToSun(float height, float density, float cosine, float scale) {
    float radii = (1.0 + height) / scale;
    float x = sqrt(0.5 * radii) * abs(cosine);
    float upward = scale * density * sqrt(2.0 * radii) / (x + sqrt(x * x + 2.0 - 0.7268 / (1.0 + x * (0.8 + 0.53 * x))));
    if (cosine >= 0.0) {
        return upward;
    }
    // Down to the lowest place and up again, less what lies behind.
    float nearest = max((1.0 + height) * sqrt(max(1.0 - cosine * cosine, 0.0)), 0.5);
    return 2.0 * scale * exp(min((1.0 - nearest) / scale, 60.0)) * sqrt(kHalfPi * nearest / scale) - upward;
}

// The mean density between two heights, and that half way. Below the ground it is as on it.
vec2 airDensities(float low, float high, float scale) {
    low = max(low, 0.0) / scale;
    high = max(high, 0.0) / scale;
    float atLow = exp(-low);
    float atHigh = exp(-high);
    float between = sqrt(atLow * atHigh);
    float rise = high - low;
    return vec2(rise > 0.02 ? (atLow - atHigh) / rise : between, between);
}

// How much of scattered sunlight comes to the camera, of the light on a white surface: by molecules and by haze.
vec2 airPhases(float cosine, float ahead) {
    float squared = ahead * ahead;
    float away = 1.0 + squared - 2.0 * ahead * cosine;
    return vec2(0.1875 * (1.0 + cosine * cosine), 0.25 * (1.0 - squared) / (away * sqrt(away)));
}

// What is seen with one more piece of the way behind it. heights: of its ends. toSunUp: the cosine between up and the way
// to the Sun.
AirSeen airPiece(AirRecord air, AirSeen seen, vec2 heights, float width, float toSunUp, vec2 phases) {
    float middle = 0.5 * (heights.x + heights.y);
    vec2 molecules = airDensities(heights.x, heights.y, air.molecules.w);
    vec2 haze = airDensities(heights.x, heights.y, air.haze.w);
    vec3 ofMolecules = air.molecules.rgb * molecules.x;
    vec3 ofHaze = air.haze.rgb * haze.x;
    vec3 lost = (ofMolecules + ofHaze) * width;
    vec3 sun = exp(-air.molecules.rgb * airToSun(middle, molecules.y, toSunUp, air.molecules.w) -
                   air.haze.rgb * airToSun(middle, haze.y, toSunUp, air.haze.w));
    vec3 passed = exp(-lost);
    // What this piece takes of its own light; the limit where it takes next to nothing.
    vec3 share = mix((1.0 - passed) / max(lost, vec3(1e-6)), 1.0 - 0.5 * lost, vec3(lessThan(lost, vec3(1e-3))));
    seen.added += seen.passed * sun * share * (ofMolecules * phases.x + ofHaze * phases.y) * width;
    seen.passed *= passed;
    return seen;
}

// Along a ray of length 1 in view space, as far as a distance in scene units. Below 0: to the planet or out of the air.
AirSeen airAlong(AirRecord air, vec3 ray, float distance) {
    AirSeen seen = AirSeen(vec3(1.0), vec3(0.0));
    vec3 ahead = ray + air.axis.xyz * dot(air.axis.xyz, ray);
    float stretch = length(ahead);
    ahead /= stretch;
    AirWay way = airWay(air.up.w, dot(ahead, air.up.xyz));
    if (way.lowest >= air.toSun.w) {
        return seen; // over all of it
    }
    float chord = airReach(way, air.toSun.w);
    float begin = max(way.nearest - chord, 0.0);
    float end = way.nearest + chord;
    if (distance >= 0.0) {
        end = min(end, distance * air.axis.w * stretch);
    } else if (way.lowest < 0.0 && way.eyeHeight > 0.0 && way.nearest > 0.0) {
        end = way.nearest - airReach(way, 0.0); // the planet
    }
    if (!(end > begin)) {
        return seen;
    }
    float lowestAt = clamp(way.nearest, begin, end);
    float low = airHeightAt(way, lowestAt);
    float offset = abs(lowestAt - way.nearest);
    float sunUp = dot(air.up.xyz, air.toSun.xyz) * (1.0 + way.eyeHeight);
    float sunAhead = dot(ahead, air.toSun.xyz);
    vec3 unstretched = air.toSun.xyz -
                       air.axis.xyz * (dot(air.axis.xyz, air.toSun.xyz) / (1.0 + dot(air.axis.xyz, air.axis.xyz)));
    vec2 phases = airPhases(dot(ray, normalize(unstretched)), air.sunlight.w);
    int first = lowestAt > begin ? 0 : kAirSteps;
    int last = end > lowestAt ? 2 * kAirSteps : kAirSteps;
    for (int step = first; step < last; ++step) {
        bool falls = step < kAirSteps;
        float rim = falls ? begin : end;
        float whole = abs(rim - lowestAt);
        float high = airHeightAt(way, rim);
        int piece = falls ? kAirSteps - 1 - step : step - kAirSteps;
        // Thin where air is thick.
        vec2 shares = vec2(piece, piece + 1) / float(kAirSteps);
        vec2 heights = low + (high - low) * shares * shares * shares;
        float middle = 0.5 * (heights.x + heights.y);
        // How far these heights are from the lowest place.
        vec3 above = vec3(heights, middle);
        vec3 reach = vec3(airReach(way, above.x), airReach(way, above.y), airReach(way, above.z));
        vec3 from = min((above - low) * (2.0 + above + low) / max(reach + offset, 1e-20), vec3(whole));
        if (piece == kAirSteps - 1) {
            from.y = whole;
        }
        float along = falls ? lowestAt - from.z : lowestAt + from.z;
        float toSunUp = (sunUp + along * sunAhead) / max(1.0 + middle, 0.5);
        seen = airPiece(air, seen, heights, (from.y - from.x) / stretch, toSunUp, phases);
    }
    seen.added *= air.sunlight.rgb;
    return seen;
}

#endif
