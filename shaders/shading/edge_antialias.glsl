// Smooths stairs along edges of brightness, after Lottes 2009, "FXAA". It finds the edge through a pixel, and walks along
// it to both ends. The nearer one tells how far the true edge reaches into the pixel. Blends linear light.
#ifndef CDR_SHADERS_EDGE_ANTIALIAS_GLSL
#define CDR_SHADERS_EDGE_ANTIALIAS_GLSL

const float kMinContrast = 1.0 / 24.0;       // below it no eye sees the stair
const float kMinRelativeContrast = 1.0 / 8.0; // of the brightest neighbour
const float kMaxSubpixel = 0.75;              // of a lone pixel's difference that is smoothed away
const int kReach = 16;                         // pixels walked along an edge each way

// Perceived brightness; a square root stands in for the sRGB curve.
float lumaAt(ivec2 pixel) { return sqrt(dot(litAt(pixel), vec3(0.2126, 0.7152, 0.0722))); }

// Steps along the edge until brightness across it changes; signed change at that end.
struct EdgeEnd {
    float pixels;
    float change;
};
EdgeEnd walk(ivec2 pixel, ivec2 along, ivec2 across, float onEdge, float gradient) {
    EdgeEnd end = EdgeEnd(float(kReach), 0.0);
    for (int i = 1; i <= kReach; ++i) {
        ivec2 here = pixel + i * along;
        end.change = 0.5 * (lumaAt(here) + lumaAt(here + across)) - onEdge;
        if (abs(end.change) >= 0.25 * gradient) {
            end.pixels = float(i);
            break;
        }
    }
    return end;
}

vec3 smoothEdges(ivec2 pixel) {
    // Brightness around, x to the right and y down.
    float l[3][3];
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            l[x][y] = lumaAt(pixel + ivec2(x - 1, y - 1));
        }
    }
    float middle = l[1][1];
    float brightest = max(middle, max(max(l[0][1], l[2][1]), max(l[1][0], l[1][2])));
    float contrast = brightest - min(middle, min(min(l[0][1], l[2][1]), min(l[1][0], l[1][2])));
    if (contrast < max(kMinContrast, kMinRelativeContrast * brightest)) {
        return litAt(pixel);
    }

    float crossing[2] = float[2](0.0, 0.0); // how much brightness bends across rows, and across columns
    for (int i = 0; i < 3; ++i) {
        float weight = i == 1 ? 2.0 : 1.0;
        crossing[0] += weight * abs(l[i][0] - 2.0 * l[i][1] + l[i][2]);
        crossing[1] += weight * abs(l[0][i] - 2.0 * l[1][i] + l[2][i]);
    }
    bool isLevel = crossing[0] >= crossing[1];
    ivec2 along = isLevel ? ivec2(1, 0) : ivec2(0, 1);
    float before = isLevel ? l[1][0] : l[0][1];
    float after = isLevel ? l[1][2] : l[2][1];
    bool isBefore = abs(before - middle) > abs(after - middle);
    ivec2 across = (isBefore ? -1 : 1) * (ivec2(1) - along);
    float beyond = isBefore ? before : after;

    float onEdge = 0.5 * (middle + beyond);
    float gradient = abs(beyond - middle);
    EdgeEnd back = walk(pixel, -along, across, onEdge, gradient);
    EdgeEnd forth = walk(pixel, along, across, onEdge, gradient);
    bool backIsNearer = back.pixels < forth.pixels;
    float nearerChange = backIsNearer ? back.change : forth.change;
    float share = 0.5 - min(back.pixels, forth.pixels) / (back.pixels + forth.pixels);
    // Only the side of the stair whose brightness the edge leaves behind is covered by the other.
    bool isCovered = (nearerChange < 0.0) != (middle < onEdge);

    float around = 2.0 * (l[1][0] + l[0][1] + l[2][1] + l[1][2]) + l[0][0] + l[2][0] + l[0][2] + l[2][2];
    float lone = smoothstep(0.0, 1.0, min(abs(around / 12.0 - middle) / contrast, 1.0));
    float blend = max(isCovered ? share : 0.0, kMaxSubpixel * lone * lone);
    return mix(litAt(pixel), litAt(pixel + across), blend);
}

#endif
