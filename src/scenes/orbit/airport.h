#pragma once

#include <scenes/orbit/earth_surface.h>
#include <scenes/scene_builder.h>

namespace cdr::scenes {

// All heights of the airport are metres over the levelled soil, y = 0. The origin is the middle of the runway
// numbers; x is east and z is south.
inline constexpr double kSlabHeight = 0.02;               ///< of runway, taxiway and apron over the soil
inline constexpr double kMarkingHeight = 0.005;           ///< of paint over the slab
inline constexpr double kCladdingThickness = 0.01;        ///< of the sheets over a hangar's walls and roof
inline constexpr const char* kConcrete = "concrete";      ///< the material of the runway's slabs
inline constexpr const char* kHangarWall = "hangar wall"; ///< a material, which shows in gaps between sheets
inline constexpr const char* kCladding = "cladding";      ///< the material of the sheets
inline constexpr double kNumberHeight = 9.0;              ///< of the characters (ICAO Annex 14, 5.2.2.5)
inline constexpr double kRunwayWest = -52.5;              ///< x of the runway's end
inline constexpr double kRunwayLength = 3'900.0;          ///< metres, 65 slabs of concrete
inline constexpr glm::dvec3 kApronParking{190.0, 0.0, -195.0}; ///< where the model stands

/// The ground that an airport asks to be level.
EarthSurface::Pad airportPad();

/// Runway 09L/27R with its markings, a taxiway, an apron and three hangars.
///
/// Slabs and sheets are boxes of their own, as in life, so that each has a near origin. The designator is on
/// one line, where real ones of parallel runways take two, so that the narrowest lens holds it whole.
void addAirport(SceneBuilder& builder);

/// A twin-engined airliner of 37 m, parked at `kApronParking`, wheels on the apron.
void addAircraft(SceneBuilder& builder);

/// Puts a scene's instances on the apron instead, as an object each, standing on the slab: a glTF model, y
/// up, in metres.
void addParkedModel(SceneBuilder& builder, const scene::Scene& model);

} // namespace cdr::scenes
