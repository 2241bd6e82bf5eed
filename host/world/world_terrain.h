#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/camera.h"
#include "host/base/colour_map.h"
#include "host/base/height_map.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/sky/clear_sky.h"
#include "host/terrain/cast/hit_planes.h"
#include "host/terrain/cast/mirrored_cast.h"
#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/shading/canopy.h"
#include "host/terrain/shading/colour_layer.h"
#include "host/terrain/shading/edge_distances.h"
#include "host/terrain/shading/materials.h"
#include "host/terrain/shading/open_sky.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"
#include "host/terrain/walk/eye_place.h"
#include "host/world/lake_look.h"
#include "host/world/terrain_light.h"
#include "kernels/shared/terrain.h"

namespace offing::world {

/// What a camera sees of ground, on a device: exactly as large as its picture, row 0 at the top.
struct TerrainImage {
  int width_px = 0, height_px = 0;
  /// [height_px][width_px]
  ocl::Buffer<TerrainHit> hits = {};
  /// [height_px][width_px] (r, g, b, coverage), kcd/m2, linear Rec.709, premultiplied.
  ocl::Buffer<terrain::Texel> image = {};
  /// [2][height_px][width_px]: the distance at which the ground or a lake is drawn, m
  /// (terrain::EdgeDistances), +inf where there is none; steps of the ray.
  ocl::Buffer<float> planes = {};

  /// Gives it the size of the camera's picture.
  void fit(const ocl::Device& device, const Camera& camera);
};

/// A map in tiles, of which a device holds as many as a budget allows.
struct TerrainTiles {
  terrain::TiledMap map;  ///< the first post is at x = z = 0, and there is nothing beyond the edges
  terrain::TileReader read;
  std::size_t cache_bytes = std::size_t{256} << 20;
};

/// The ground of a world: either a map in memory or one in tiles.
struct TerrainParameters {
  std::shared_ptr<const HeightMap> map;
  std::shared_ptr<const TerrainTiles> tiles = {};
  double origin_x_m = 0.0, origin_z_m = 0.0;  ///< of the first post
  std::optional<double> latitude_deg;         ///< of the map's middle, where its file tells
  CoverLines lines;
  std::shared_ptr<const ColourMap> colours = {};  ///< none: cover by height and slope
  double relief = 1.0;                            ///< strength of relief between posts, near the eye
  double finest_detail_m = 0.0;  ///< patterns of the ground that are finer show as their mean
  bool sees_horizons = false;    ///< whether ground hides the sky's light from ground
  std::vector<LakeSettings> lakes = {};
  std::vector<terrain::Material> materials = {};  ///< over the cover by height and slope
  std::optional<terrain::Canopy> canopy = {};     ///< woods over all of these

  bool operator==(const TerrainParameters&) const = default;

  /// Posts of tiles that cannot be read are stood in for. Keeps what it answers about.
  terrain::TerrainPosts posts() const;
  /// Of the map, as if its first post were at x = z = 0.
  terrain::TerrainExtent extent() const;
};

/// Whether a picture waits for tiles; if not, coarser ones stand in for those that are not there yet.
enum class TileWait { none, all };

/// What falls on the ground beside what the sky's tables have.
struct TerrainLighting {
  TerrainLight light;
  const terrain::CloudShade* clouds = nullptr;  ///< none: no clouds shade it
};

/// The ground of a world on a device, and what a camera sees of it.
class WorldTerrain {
 public:
  /// Throws what HeightField or TiledField throws.
  WorldTerrain(const ocl::Device& device, const TerrainParameters& parameters);

  const TerrainParameters& parameters() const { return parameters_; }
  /// The same heights in the same place, with the lines, the colours and the horizons of these parameters.
  /// One that throws has changed nothing. Throws what ColourLayer and OpenSky throw.
  void set_cover(const TerrainParameters& parameters);
  /// nullptr where the ground is in tiles.
  const terrain::HeightField* field() const { return field_ ? &*field_ : nullptr; }
  /// nullptr where it is not.
  const terrain::TiledField* tiles() const { return tiles_ ? &*tiles_ : nullptr; }
  /// That of the last at().
  const terrain::ReliefSurface& relief() const { return relief_; }
  /// What a ray hits first, of tiles those of the last at().
  terrain::RayHit cast(const terrain::Ray& ray);
  /// From now on there is no relief within these discs (x, z of the world).
  void set_level_discs(std::vector<terrain::LevelDisc> discs);
  terrain::ReliefSettings relief_settings() const;
  /// Metres by which relief raises the drawn ground there, for an eye that stands on it; 0 beyond the map's
  /// edge.
  double relief_m(double x_m, double z_m) const;
  /// The ground above or below a point of the world; nothing beyond the map's edge.
  std::optional<terrain::TerrainPoint> terrain_at(double x_m, double z_m) const;

  /// The same with lakes over the ground.
  std::optional<double> surface_m(double x_m, double z_m) const;
  /// Where a ray that hits ground at this distance crosses the surface of a lake before; nothing if it
  /// crosses none.
  std::optional<glm::dvec3> water_before(const terrain::Ray& ray, double distance_m) const;
  /// The time of the waves of lakes from now on.
  void set_time(double time_s) { time_s_ = time_s; }

  /// Enqueues what this camera sees under a sky whose eye is the camera's: nothing from where no rays reach
  /// the map (terrain::farthest_origin_cells). Throws what require_valid(camera) throws, Error(bad_input) for
  /// a sampling out of range.
  void at(const Camera& camera, const sky::ClearSky& sky, const TerrainLighting& light,
          const terrain::Sampling& sampling, TileWait wait = TileWait::all,
          const terrain::SeaOverTerrain& sea = {});
  /// Whether the camera of the last at() was near enough; only then is there anything of what follows.
  bool is_in_reach() const { return is_in_reach_; }

  /// What at() made.
  const TerrainImage& image() const { return image_; }

  /// Enqueues what a camera, whose eye is that of the last at(), sees beneath a sea, with one ray a pixel:
  /// ground that is deeper than `sea` says is left out. Of tiles those of the last at(), so that none is
  /// loaded for it. Throws what at() throws.
  void beneath_at(const Camera& camera, const sky::ClearSky& sky, const TerrainLighting& light,
                  const terrain::SeaOverTerrain& sea);
  /// What beneath_at() made; nullptr where the last at() found nothing in reach.
  const TerrainImage* beneath() const { return is_in_reach_ ? &beneath_ : nullptr; }

  /// Enqueues what a sea at height `plane_m` mirrors of the ground for this camera, whose eye is the mirrored
  /// one (offing::mirrored()), with one ray a pixel. A map in tiles is not mirrored. Throws what at() throws.
  void mirror_at(const Camera& mirrored, double plane_m, const sky::ClearSky& sky,
                 const TerrainLighting& light);
  /// What mirror_at() made; nullptr where it found nothing in reach.
  const TerrainImage* mirrored() const { return is_mirrored_ ? &mirrored_ : nullptr; }

 private:
  /// What the relief of a map was laid for.
  struct ReliefView {
    Camera camera;
    terrain::ReliefSettings settings;

    bool operator==(const ReliefView&) const = default;
  };

  /// Lays the relief that a camera sees, unless it lies there.
  void lay_relief(const Camera& camera);
  /// Whether ground that may have relief, seen by this camera, rises above its shore.
  bool rises_near(const Camera& camera, double shore_m);
  terrain::TerrainAppearance look_of(const terrain::Sampling& sampling,
                                     const terrain::SeaOverTerrain& sea) const;
  void make_lakes(const TerrainParameters& parameters);
  void make_materials(const TerrainParameters& parameters);
  void make_canopy(const TerrainParameters& parameters);
  /// How lakes look to this camera.
  void look_at_lakes(const Camera& camera, const terrain::TerrainIllumination& light);
  /// Gives a picture its planes.
  template <class Field>
  void lay_planes(const Field& field, const Camera& camera, const terrain::SeaOverTerrain& sea,
                  const terrain::LakeLayer* lakes, TerrainImage& picture);
  void paint(const Camera& camera, const terrain::TerrainIllumination& light,
             const terrain::Sampling& sampling, const terrain::SeaOverTerrain& sea, TerrainImage& picture);

  ocl::Device device_;
  TerrainParameters parameters_;
  terrain::TerrainPosts posts_;
  std::optional<terrain::HeightField> field_;  // either this
  std::optional<terrain::TiledField> tiles_;   // or this
  terrain::TerrainShade shade_;
  terrain::HitPlanes hit_planes_;
  terrain::EdgeDistances edge_distances_;
  terrain::MirroredCast mirrored_cast_;
  terrain::ReliefSurface relief_;  // of the eye of the last at()
  std::optional<ReliefView> laid_;
  /// The highest post of the map near a post.
  struct {
    glm::ivec2 post{-1};
    float height_m = 0.0f;
  } near_;
  std::vector<terrain::LevelDisc> level_discs_;
  std::optional<terrain::ColourLayer> colours_;
  std::optional<terrain::OpenSky> open_sky_;
  std::optional<terrain::LakeLayer> lakes_;
  std::optional<terrain::MaterialLayer> materials_;
  std::optional<terrain::CanopyLayer> canopy_;
  double time_s_ = 0.0;
  TerrainImage image_, beneath_, mirrored_;
  ocl::Buffer<float> distances_m_;  // along the own rays of the pixels of the last of these
  bool is_in_reach_ = false, is_mirrored_ = false;
};

}  // namespace offing::world
