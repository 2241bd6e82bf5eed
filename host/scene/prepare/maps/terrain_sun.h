#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/height_map.h"
#include "host/io/height_maps/map_coordinates.h"
#include "host/sky/direct_sunlight.h"
#include "host/sky/sun_position.h"
#include "host/terrain/analysis/horizons.h"

namespace offing::scene {

/// When the sun is looked at, through which air, and how finely horizons are divided.
struct SunSettings {
  std::int64_t from_s = 0, to_s = 0;  ///< seconds since 1970-01-01T00:00Z; years 1900 to 2100
  std::int64_t step_s = 3600;
  double linke_turbidity = sky::usual_turbidity;
  int azimuths = terrain::usual_azimuths;
  terrain::EarthCurve curve{};
};

inline constexpr std::int64_t most_moments = 100'000;

/// Throws Error(bad_input) that names what is out of range.
void require_valid(const SunSettings& settings);

/// A place from which the sun is looked at, and how a map lies there.
struct SunPlace {
  sky::GeoPosition position;
  double north_rad = 0.0;  ///< of the map's north, -z, clockwise from true north: meridian convergence
};

/// Throws Error(bad_input) that names the map if it does not say where it lies in the world.
void require_place(const MapFrame& map);
/// Those of places (x_m, z_m) on a map. Throws what require_place() throws.
std::vector<SunPlace> sun_places(const MapFrame& map, std::span<const glm::dvec2> places_m);

/// The sun over a map from moment to moment: how long it shines on each post, how much of its light the
/// ground there gets under a clear sky, and where it shines at a moment; a band of rows at a time.
///
/// The sun shines where any part of its disc, lifted by the refraction of air at sea level, is above the
/// horizon, as almanacs have sunrise: over level ground from -0.833 degrees on. It is computed at the corners
/// of blocks of 128 x 64 posts, and linear between them. Directions are turned by the map's meridian
/// convergence. Horizons are linear between azimuths. The moments are from_s, from_s + step_s, ... and to_s;
/// between two of them what the sun stands above the horizon, and its light, are linear.
class TerrainSun {
 public:
  /// `place` is that of the whole map, which then lies north up; without it the map's georeference says where
  /// it lies. Map and field are of the same posts, and outlive it. Throws what require_valid() and
  /// sun_places() throw.
  TerrainSun(const ocl::Device& device, const terrain::HeightField& field, const HeightMap& map,
             MapFrame frame, const std::optional<sky::GeoPosition>& place, const SunSettings& settings);
  TerrainSun(TerrainSun&&) noexcept;
  TerrainSun& operator=(TerrainSun&&) noexcept;
  ~TerrainSun();

  /// Moments at which the sun is up somewhere over the map, s since 1970.
  const std::vector<std::int64_t>& up_s() const;
  /// The map's rows, in bands that read() takes.
  std::vector<terrain::RowBand> bands() const;

  /// Hours of sun, and kWh a square metre of ground, inclined as it is: [rows][columns].
  void read(const terrain::RowBand& band, std::span<float> hours, std::span<float> energy_kwh);
  /// 255 where the sun shines at up_s()[number], else 0: [rows][columns] of the band that was last read.
  void read_mask(const terrain::RowBand& band, std::size_t number, std::span<std::uint8_t> lit);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing::scene
