#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/ocl/buffer.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/shading/terrain_shade.h"
#include "tests/terrain/example_maps.h"

namespace offing::test {

/// A red sun in the east, a dimmer red sky, air that does nothing; all ground is water.
struct PaintedTerrain {
  TerrainLight light = clear_light();
  double sun_elevation_rad = 0.6, sun_radius_rad = 0.00465;
  float haze_kcdpm2 = 3.0f;  ///< of the sky in all directions

  static TerrainLight clear_light();
  /// The same with three colours and with cover that changes within the heights of `map`.
  static PaintedTerrain covered(const HeightMap& map);
};

/// Pictures of a map, on the default device.
class TerrainPainter {
 public:
  TerrainPainter(const HeightMap& map, const PaintedTerrain& scene);

  /// From now on, pictures show relief.
  void show_relief(const terrain::ReliefSettings& settings) { relief_settings_ = settings; }
  /// [height_px][width_px] (r, g, b, coverage).
  std::vector<terrain::Texel> draw(const Camera& camera, terrain::TerrainAppearance look);
  /// What a level plane shows to a camera that is mirrored in it.
  std::vector<terrain::Texel> draw_mirrored(const Camera& mirrored, double plane_m);
  /// Of the last picture [height_px][width_px].
  std::vector<TerrainHit> hits() const { return hits_->read(); }
  const ocl::Device& device() const { return device_; }
  const terrain::HeightField& field() const { return field_; }
  double refined_share() const { return shade_.refined_share(); }

 private:
  ocl::Device device_;
  terrain::HeightField field_;
  terrain::TerrainShade shade_;
  terrain::ReliefSurface relief_;
  terrain::ReliefSettings relief_settings_{.strength = 0.0};
  TerrainLight light_;
  SkyParams sky_;
  ocl::Buffer<terrain::Texel> view_table_;
  std::optional<ocl::Buffer<TerrainHit>> hits_;
};

}  // namespace offing::test
