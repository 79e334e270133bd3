#include <scenes/orbit/airport.h>
#include <scenes/orbit/runway_marking.h>

#include <fmt/format.h>

#include <string_view>

namespace cdr::scenes {

namespace {

constexpr double kRunwayHalfWidth = 25.0;
constexpr double kSlabLength = 60.0;
constexpr double kSlabHalfDepth = 0.125;
constexpr double kPaintHeight = kSlabHeight + kMarkingHeight;

/// Neighbouring slabs overlap by this, else float32 would leave thin lines of soil between them.
constexpr double kSlabOverlap = 0.002;

/// A slab of concrete, most of it below the soil.
void addSlab(SceneBuilder& builder, std::uint32_t material, const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec2 middle = 0.5 * (low + high);
    const glm::dvec2 half = 0.5 * (high - low) + kSlabOverlap;
    builder.addBox(material, {middle.x, kSlabHeight - kSlabHalfDepth, middle.y},
                   {half.x, kSlabHalfDepth, half.y});
}

/// Slabs over a rectangle of x and z, as square as they fit.
void addPavement(SceneBuilder& builder, std::uint32_t material, const glm::dvec2& low,
                 const glm::dvec2& high) {
    const glm::dvec2 count = glm::ceil((high - low) / kSlabLength);
    const glm::dvec2 step = (high - low) / count;
    for (double j = 0.0; j < count.y; ++j) {
        for (double i = 0.0; i < count.x; ++i) {
            const glm::dvec2 corner = low + step * glm::dvec2(i, j);
            addSlab(builder, material, corner, corner + step);
        }
    }
}

/// Which way somebody rolls who reads a marking.
enum class Heading : std::uint8_t { east, west };

/// Where a marking's own plane lies: over a point of the runway.
glm::dmat4 paintedAt(double x, double z, Heading heading) {
    const double turn = heading == Heading::west ? -1.0 : 1.0;
    return {{turn, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, turn, 0.0}, {x, kPaintHeight, z, 1.0}};
}

/// Threshold stripes, aiming point and touchdown zone of one end; `x` where its designator stands.
void addEndMarkings(SceneBuilder& builder, std::uint32_t paint, double x, Heading heading) {
    MarkingPaint stripes("threshold");
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < 6; ++i) {
            const double middle = side * (2.7 + 3.6 * i);
            stripes.rectangle({middle - 0.9, -46.5}, {middle + 0.9, -16.5});
        }
        const double aim = side * 14.0;
        stripes.rectangle({aim - 5.0, 350.0}, {aim + 5.0, 410.0});
        for (const double zone : {150.0, 300.0, 600.0}) {
            stripes.rectangle({side * 12.0 - 1.5, zone}, {side * 12.0 + 1.5, zone + 22.5});
        }
    }
    builder.addMesh(paint, stripes.mesh(), paintedAt(x, 0.0, heading));
}

void addRunway(SceneBuilder& builder, std::uint32_t concrete, std::uint32_t paint) {
    const double east = kRunwayWest + kRunwayLength;
    const double eastNumbers = east + kRunwayWest; // as far from its end as the others
    const auto designator = [&](std::string_view text, double x, Heading heading) {
        builder.beginObject(fmt::format("numbers {}", text));
        MarkingPaint numbers{std::string(text)};
        numbers.text(text, kNumberHeight);
        builder.addMesh(paint, numbers.mesh(), paintedAt(x, 0.0, heading));
    };
    designator("09L", 0.0, Heading::east);
    designator("27R", eastNumbers, Heading::west);

    builder.beginObject("runway markings");
    addEndMarkings(builder, paint, 0.0, Heading::east);
    addEndMarkings(builder, paint, eastNumbers, Heading::west);
    MarkingPaint dash("centre line");
    dash.rectangle({-0.45, -15.0}, {0.45, 15.0});
    for (double x = 45.0; x < eastNumbers - 40.0; x += 50.0) {
        builder.addMesh(paint, dash.mesh(), paintedAt(x, 0.0, Heading::east));
    }
    MarkingPaint side("side line");
    side.rectangle({-0.45, -0.5 * kSlabLength}, {0.45, 0.5 * kSlabLength});
    for (double x = kRunwayWest + 0.5 * kSlabLength; x < east; x += kSlabLength) {
        for (const double z : {-kRunwayHalfWidth + 1.0, kRunwayHalfWidth - 1.0}) {
            builder.addMesh(paint, side.mesh(), paintedAt(x, z, Heading::east));
        }
    }

    builder.beginObject("runway 09L/27R");
    addPavement(builder, concrete, {kRunwayWest, -kRunwayHalfWidth}, {east, kRunwayHalfWidth});
}

void addTaxiway(SceneBuilder& builder, std::uint32_t asphalt, std::uint32_t yellow) {
    builder.beginObject("taxiway markings");
    MarkingPaint line("taxi line");
    line.rectangle({-kRunwayHalfWidth - 160.0, 189.9}, {-kRunwayHalfWidth, 190.1});
    builder.addMesh(yellow, line.mesh(), paintedAt(0.0, 0.0, Heading::east));
    builder.beginObject("apron and taxiway");
    addPavement(builder, asphalt, {40.0, -340.0}, {340.0, -150.0});
    addPavement(builder, asphalt, {178.0, -150.0}, {201.0, -kRunwayHalfWidth});
}

/// Sheets of cladding side by side on one side of a box, a tenth of each a gap that shows the wall.
void addCladding(SceneBuilder& builder, std::uint32_t material, const glm::dvec3& centre,
                 const glm::dvec3& half, int normalAxis, double side, int alongAxis) {
    const double width = 2.0 * half[alongAxis];
    const double sheets = std::round(width);
    glm::dvec3 sheetHalf = half;
    sheetHalf[normalAxis] = 0.5 * kCladdingThickness;
    sheetHalf[alongAxis] = 0.45 * width / sheets;
    for (double i = 0.0; i < sheets; ++i) {
        glm::dvec3 middle = centre;
        middle[normalAxis] += side * (half[normalAxis] + 0.5 * kCladdingThickness);
        middle[alongAxis] += width * ((i + 0.5) / sheets - 0.5);
        builder.addBox(material, middle, sheetHalf);
    }
}

void addHangar(SceneBuilder& builder, std::uint32_t wall, std::uint32_t sheet, double x, int number) {
    const glm::dvec3 half(35.0, 9.0, 25.0);
    const glm::dvec3 centre(x, kSlabHeight + half.y, -300.0);
    builder.beginObject(fmt::format("hangar {} cladding", number));
    addCladding(builder, sheet, centre, half, 1, 1.0, 0);
    for (const double side : {-1.0, 1.0}) {
        addCladding(builder, sheet, centre, half, 0, side, 2);
        addCladding(builder, sheet, centre, half, 2, side, 0);
    }
    builder.beginObject(fmt::format("hangar {}", number));
    builder.addBox(wall, centre, half);
}

} // namespace

EarthSurface::Pad airportPad() {
    return {.centre = {kRunwayWest + 0.5 * kRunwayLength, 0.0}, .radius = 2'600.0};
}

void addAirport(SceneBuilder& builder) {
    const std::uint32_t concrete = builder.addMaterial(kConcrete, glm::vec3(0.23f, 0.23f, 0.225f));
    const std::uint32_t asphalt = builder.addMaterial("asphalt", glm::vec3(0.11f));
    const std::uint32_t white = builder.addMaterial("white paint", glm::vec3(0.8f));
    const std::uint32_t yellow = builder.addMaterial("yellow paint", glm::vec3(0.75f, 0.5f, 0.04f));
    const std::uint32_t wall = builder.addMaterial(kHangarWall, glm::vec3(0.12f, 0.05f, 0.03f));
    const std::uint32_t sheet = builder.addMaterial(kCladding, glm::vec3(0.42f, 0.52f, 0.6f));
    for (int i = 0; i < 3; ++i) {
        addHangar(builder, wall, sheet, 90.0 + 90.0 * i, i + 1);
    }
    addRunway(builder, concrete, white);
    addTaxiway(builder, asphalt, yellow);
}

} // namespace cdr::scenes
