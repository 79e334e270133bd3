// Whether an instance is an occluder, and whether it is hidden: as visibility::Occluders and visibility::dropHidden() say,
// though they look at more levels of squares. Either errs towards what is seen.
#ifndef CDR_SHADERS_HIDDEN_GLSL
#define CDR_SHADERS_HIDDEN_GLSL

#include "occluders/occluders.glsl"

bool wasSeen(uint instance) {
    return occluders.hasSeen == 0u || (seen[instance / 32u] >> (instance % 32u) & 1u) != 0u;
}

bool isOccluder(uint instance, InstanceSphere sphere) {
    bool isLarge = double(sphere.radius) >= occluders.leastRadius * viewDistance(sphere);
    return isLarge && wasSeen(instance) && materials[looks[instance].material].occludes != 0u;
}

// What is beyond `end`, or not a number, is the last one.
uint pixelOf(double at, uint end) {
    return at < double(end) ? uint(max(at, 0.0lf)) : end - 1u;
}

// @param side of a place, in pixels.
bool hidesAll(uvec4 pixels, uint side, uint first, uint columns, double nearestView) {
    uvec4 places = pixels / side;
    for (uint row = places.y; row <= places.w; ++row) {
        for (uint column = places.x; column <= places.z; ++column) {
            if (!(nearestView > double(hiddenBeyond[first + row * columns + column]))) {
                return false;
            }
        }
    }
    return true;
}

bool isHidden(InstanceSphere sphere) {
    const double kRim = 1.0lf; // pixels
    double w = viewDistance(sphere);
    double x = along(view.right, sphere) - w * view.centreX;
    double y = along(view.up, sphere) - w * view.centreY;
    double radius = double(sphere.radius);
    double near = w - radius;
    double far = w + radius;
    if (!(near > view.nearView)) {
        return false;
    }
    double width = double(occluders.width);
    double height = double(occluders.height);
    // Along the axes of a picture whose lens is shifted, a sphere reaches a little farther.
    double reachX = radius * (1.0lf + abs(view.centreX));
    double reachY = radius * (1.0lf + abs(view.centreY));
    double left = x - reachX;
    double right = x + reachX;
    double low = y - reachY;
    double high = y + reachY;
    left = (0.5lf + 0.5lf * left / ((left < 0.0lf ? near : far) * occluders.tanX)) * width - kRim;
    right = (0.5lf + 0.5lf * right / ((right < 0.0lf ? far : near) * occluders.tanX)) * width + kRim;
    double top = (0.5lf - 0.5lf * high / ((high < 0.0lf ? far : near) * occluders.tanY)) * height - kRim;
    double bottom = (0.5lf - 0.5lf * low / ((low < 0.0lf ? near : far) * occluders.tanY)) * height + kRim;
    if (right <= 0.0lf || bottom <= 0.0lf || left >= width || top >= height) {
        return true;
    }
    uvec4 pixels = uvec4(pixelOf(left, occluders.width), pixelOf(top, occluders.height),
                         pixelOf(right, occluders.width), pixelOf(bottom, occluders.height));
    double nearestView = near - radius;
    const uint kMaxAcross = 8u * kTileSide; // what is larger is looked at by squares
    if (max(pixels.z - pixels.x, pixels.w - pixels.y) < kMaxAcross) {
        return hidesAll(pixels, kTileSide, 0u, occluders.columns, nearestView);
    }
    return hidesAll(pixels, kTileSide * kSquareSide, firstSquare(), squareColumns(), nearestView);
}

#endif
