#include <scenes/earth/countryside.h>
#include <scenes/earth/noise.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::scenes {

namespace {

// Linear colours.
constexpr glm::dvec3 kAsphalt(0.10, 0.10, 0.105);
constexpr glm::dvec3 kRiver(0.02, 0.045, 0.06);
constexpr glm::dvec3 kLawn(0.10, 0.155, 0.045);
constexpr glm::dvec3 kTown(0.17, 0.145, 0.10);
constexpr glm::dvec3 kWood(0.042, 0.07, 0.006); ///< and a part of the land's

// Waves, metres.
constexpr Waves kHills{.longest = 80e3, .shortest = 30.0, .gain = 0.8, .seed = 21};
constexpr Waves kDry{.longest = 50e3, .shortest = 2e3, .gain = 0.5, .seed = 22};
constexpr Waves kWoods{.longest = 6'400.0, .shortest = 12.0, .gain = 0.7, .seed = 41};
constexpr Waves kMottle{.longest = 2'400.0, .shortest = 14.0, .gain = 0.85, .seed = 43};
constexpr Waves kTowns{.longest = 17e3, .shortest = 500.0, .gain = 0.55, .seed = 51};

/// How much of a texel a line covers whose middle is so far away; metres.
double lineShare(double distance, double width, double texel) {
    const double blur = std::max(texel, 0.5);
    const double inside = std::clamp((0.5 * (width + blur) - std::abs(distance)) / blur, 0.0, 1.0);
    return inside * std::min(1.0, width / blur);
}

/// Metres to where a wave is 0: such lines wind through the country like roads.
double toContour(const Wave& wave) {
    return wave.value / std::max(glm::length(wave.slope), 1e-9);
}

/// How far single texels differ that are larger than what they show, as means of many would.
double speckled(double texel, double length) {
    return std::clamp(length / texel - 0.1, 0.0, 1.0);
}

/// Half the width of a step. The step stands for the share of ground above a height, if texels leave out so much of a sum.
double blurOf(const Waves& waves, double texel) {
    return 0.7 * leftOut(waves, texel);
}

constexpr std::array<glm::dvec3, 8> kCrops{{{0.80, 1.05, 0.6},
                                            {1.0, 1.25, 0.7},
                                            {0.65, 0.9, 0.5},
                                            {1.75, 1.5, 0.9},
                                            {1.35, 1.05, 0.8},
                                            {0.85, 1.15, 0.5},
                                            {1.45, 1.4, 0.7},
                                            {1.15, 1.0, 0.75}}};
constexpr glm::dvec3 kMeanCrop(1.12, 1.16, 0.68);

/// What a field's crop multiplies the land's colour by.
glm::dvec3 cropOf(double number) {
    return kCrops[std::min(static_cast<std::size_t>(number * kCrops.size()), kCrops.size() - 1)];
}

/// A place within a cell of bricks of unlike sizes.
struct Brick {
    double number;   ///< of the cell, 0 to below 1
    double toBorder; ///< metres
    double along;    ///< metres
};

Brick brickAt(const glm::dvec2& place, const glm::dvec2& size, std::uint32_t seed) {
    const std::int64_t row = cellOf(place.y / size.y);
    const double shifted = place.x / size.x + cellNumber(row, 0, seed);
    const std::int64_t column = cellOf(shifted);
    const double x = (shifted - static_cast<double>(column)) * size.x;
    const double y = place.y - static_cast<double>(row) * size.y;
    // A third of the way, or two, some are divided.
    const double divided = cellNumber(column, row, seed + 1);
    const double cut = divided < 0.7 ? size.x * (divided < 0.35 ? 0.36 : 0.62) : 0.0;
    const double left = x < cut ? 0.0 : cut;
    const double right = x < cut ? cut : size.x;
    return {.number = cellNumber(column, row, seed + (x < cut ? 2 : 3)),
            .toBorder = std::min({x - left, right - x, y, size.y - y}),
            .along = divided < 0.5 ? x : y};
}

glm::dvec3 fields(const glm::dvec3& land, const glm::dvec2& bent, double texel) {
    const double shown = speckled(texel, 340.0);
    if (shown <= 0.0) {
        return land * kMeanCrop;
    }
    const Brick field =
        brickAt({0.83 * bent.x - 0.56 * bent.y, 0.56 * bent.x + 0.83 * bent.y}, {430.0, 270.0}, 33);
    glm::dvec3 crop = cropOf(field.number);
    crop *= 1.0 + 0.07 * shownBy(texel, 26.0) * std::sin(field.along * 0.48);
    crop = glm::mix(crop, glm::dvec3(0.45, 0.6, 0.35), 0.8 * lineShare(field.toBorder, 9.0, texel));
    return land * glm::mix(kMeanCrop, crop, shown);
}

glm::dvec3 woods(const glm::dvec3& color, const glm::dvec3& land, const Country& country,
                 const glm::dvec2& place, const Fineness& fineness) {
    const double thick = country.woods + sumWaves(kWoods, place, fineness, WavePart::beyondGrid);
    const double share = smoothStep(0.46 - country.woodsBlur, 0.5 + country.woodsBlur, thick);
    if (share <= 0.0) {
        return color;
    }
    const double crowns = 1.0 + 0.22 * sumWaves(kMottle, place, fineness.texel) +
                          0.2 * shownBy(fineness.texel, 14.0) * waveAt(place, 14.0, 42).value;
    return glm::mix(color, (kWood + 0.3 * land) * std::max(crowns, 0.3), share);
}

glm::dvec3 towns(const glm::dvec3& color, const Country& country, const glm::dvec2& place,
                 const Fineness& fineness) {
    const double dense = country.towns + sumWaves(kTowns, place, fineness, WavePart::beyondGrid);
    const double share = 0.9 * smoothStep(0.62 - country.townsBlur, 1.25 + country.townsBlur, dense);
    if (share <= 0.0) {
        return color;
    }
    const double texel = fineness.texel;
    const glm::dvec2 bent = place + country.bend;
    const double shown = speckled(texel, 300.0);
    const glm::dvec3 afar = glm::mix(color, kTown, share);
    if (shown <= 0.0) {
        return afar;
    }
    const Brick quarter = brickAt(bent, {900.0, 620.0}, 60);
    const glm::dvec2 turned =
        quarter.number < 0.5 ? bent : glm::dvec2(0.8 * bent.x + 0.6 * bent.y, 0.8 * bent.y - 0.6 * bent.x);
    const Brick block = brickAt(turned, {190.0, 95.0}, 54);
    // Towns thin out block by block.
    if (block.number > 1.1 * share) {
        return glm::mix(afar, color, shown);
    }
    const Brick house = brickAt(turned, {24.0, 17.0}, 57);
    const bool isGarden = house.number < 0.45 || house.toBorder < 2.0;
    const glm::dvec3 roof =
        house.number < 0.75 ? glm::dvec3(0.23, 0.125, 0.085) : glm::dvec3(0.22, 0.22, 0.23);
    const glm::dvec3 inside = isGarden ? glm::dvec3(0.08, 0.105, 0.045) : roof * (0.7 + 0.7 * quarter.number);
    const glm::dvec3 built = glm::mix(kTown * (0.65 + 0.4 * block.number / share + 0.2 * quarter.number),
                                      inside, shownBy(texel, 20.0));
    return glm::mix(afar, glm::mix(built, kAsphalt, lineShare(block.toBorder, 9.0, texel)), shown);
}

glm::dvec3 linesOf(const glm::dvec3& color, const Country& country, double texel) {
    glm::dvec3 seen = glm::mix(color, kRiver, lineShare(country.river, 130.0, texel));
    seen = glm::mix(seen, kAsphalt, 0.9 * lineShare(country.lane, 6.0, texel));
    return glm::mix(seen, kAsphalt, lineShare(country.road, 22.0, texel));
}

/// Metres into the airport's fence, negative outside.
double insideFence(const glm::dvec2& place) {
    constexpr glm::dvec2 kMiddle(1'900.0, -90.0);
    constexpr glm::dvec2 kHalf(2'150.0, 330.0);
    const glm::dvec2 beyond = glm::abs(place - kMiddle) - kHalf;
    const double toRectangle =
        glm::length(glm::max(beyond, glm::dvec2(0.0))) + std::min(std::max(beyond.x, beyond.y), 0.0);
    return 110.0 - toRectangle + 70.0 * waveAt(place, 620.0, 72).value;
}

glm::dvec3 lawnAt(const glm::dvec2& place, double texel) {
    const double patches =
        sumWaves({.longest = 300.0, .shortest = 1.0, .gain = 0.6, .seed = 71}, place, texel);
    const double tufts = sumWaves({.longest = 12.0, .shortest = 1.0, .gain = 0.85, .seed = 73}, place, texel);
    const double mown = shownBy(texel, 24.0) * std::tanh(6.0 * std::sin(place.y * 0.26));
    return kLawn * (1.0 + 0.2 * patches + 0.04 * mown + 0.13 * tufts);
}

/// The country without the airport.
glm::dvec3 openCountry(const glm::dvec3& color, const Country& country, const glm::dvec2& place,
                       const Fineness& fineness) {
    const double texel = fineness.texel;
    // Texels beyond this show none of it.
    constexpr double kFromAfar = 600.0;
    const double hills = country.hills + sumWaves(kHills, place, fineness, WavePart::beyondGrid);
    // What is bright from afar is desert or snow.
    const double farmed = 1.0 - smoothStep(0.16, 0.35, color.g);
    // Along coasts the marble has bluish land, which plants are not.
    const glm::dvec3 green(std::max(color.r, 0.65 * color.g), color.g, std::min(color.b, 0.3 * color.g));
    const glm::dvec3 land = glm::mix(color, green, farmed) * std::max(1.0 + 0.25 * hills, 0.3) *
                            (1.0 + country.dry * glm::dvec3(0.16, 0.04, -0.06));
    if (farmed <= 0.0) {
        return land;
    }
    const glm::dvec2 bent = place + country.bend;
    glm::dvec3 seen = fields(land, bent, texel);
    seen = woods(seen, land, country, place, fineness);
    seen = towns(seen, country, place, fineness);
    seen = texel < kFromAfar ? linesOf(seen, country, texel) : seen;
    return glm::mix(land, seen, farmed);
}

} // namespace

Country countryAt(const glm::dvec2& place, const Fineness& fineness) {
    const glm::dvec2 wound =
        place + 900.0 * glm::dvec2(waveAt(place, 6e3, 61).value, waveAt(place, 6e3, 62).value);
    return {.hills = sumWaves(kHills, place, fineness, WavePart::ofGrid),
            .dry = sumWaves(kDry, place, fineness.texel),
            .woods = sumWaves(kWoods, place, fineness, WavePart::ofGrid),
            .towns = sumWaves(kTowns, place, fineness, WavePart::ofGrid),
            .woodsBlur = blurOf(kWoods, fineness.texel),
            .townsBlur = blurOf(kTowns, fineness.texel),
            .bend = 90.0 * glm::dvec2(waveAt(place, 1'100.0, 31).value, waveAt(place, 1'100.0, 32).value),
            .river = toContour(waveAt(wound, 70e3, 63)),
            .road = toContour(waveAt(place, 11e3, 65)),
            .lane = toContour(waveAt(place, 2'700.0, 66))};
}

Country between(const Country& a, const Country& b, double share) {
    return {.hills = blend(a.hills, b.hills, share),
            .dry = blend(a.dry, b.dry, share),
            .woods = blend(a.woods, b.woods, share),
            .towns = blend(a.towns, b.towns, share),
            .woodsBlur = blend(a.woodsBlur, b.woodsBlur, share),
            .townsBlur = blend(a.townsBlur, b.townsBlur, share),
            .bend = glm::mix(a.bend, b.bend, share),
            .river = blend(a.river, b.river, share),
            .road = blend(a.road, b.road, share),
            .lane = blend(a.lane, b.lane, share)};
}

glm::dvec3 countryColor(const glm::dvec3& color, const Country& country, const glm::dvec2& place,
                        const Fineness& fineness) {
    const double texel = fineness.texel;
    if (std::abs(place.x) + std::abs(place.y) >= 6e3 + texel) {
        return openCountry(color, country, place, fineness);
    }
    const double inside = insideFence(place);
    const double lawn = std::clamp(inside / std::max(texel, 1.0) + 0.5, 0.0, 1.0);
    const glm::dvec3 outer = lawn < 1.0 ? openCountry(color, country, place, fineness) : kLawn;
    const glm::dvec3 seen = lawn > 0.0 ? glm::mix(outer, lawnAt(place, texel), lawn) : outer;
    return glm::mix(seen, kAsphalt, lineShare(inside, 6.0, texel));
}

} // namespace cdr::scenes
