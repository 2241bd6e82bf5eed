#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/base/rgba_image.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/slope_covariance.h"
#include "host/ocean/spectrum/wind.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocean/surface/projected_grid.h"
#include "host/ocean/surface/swash.h"
#include "host/ocean/surface/water_optics.h"
#include "host/ocl/device.h"
#include "host/sky/atmosphere.h"
#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"
#include "host/world/light_lag.h"
#include "host/world/mesh_parameters.h"
#include "host/world/world_bodies.h"
#include "host/world/world_clouds.h"
#include "host/world/world_mesh.h"
#include "host/world/world_terrain.h"
#include "host/world/world_wakes.h"

namespace offing::world {

/// Everything that a world is made of: no file names, no defaults left to choose.
struct WorldParameters {
  bool has_sea = true;  ///< without one, all down to the wind says nothing
  ocean::SeaSpectrum spectrum = {};
  ocean::OceanParameters ocean = {};
  double sea_level_m = 0.0;  ///< of the still sea, from the zero of terrain heights; 0 without a sea
  bool has_shoals = true;    ///< whether waves shoal over the ground, if there is any
  std::vector<WakeSettings> wakes = {};
  ocean::Wind wind = {};  ///< over the ripples that the spectrum or its maps leave out
  ocean::WaterType water = ocean::WaterType::oceanic_1b;
  sky::Atmosphere atmosphere = {};
  sky::Sun sun = {};
  std::optional<TerrainParameters> terrain = {};
  std::optional<CloudSkyParameters> clouds = {};
  std::vector<MeshParameters> meshes = {};
  std::vector<BodySettings> bodies =
      {};                          ///< in a world with a sea; they move meshes in place of their motion
  double run_up_s = 10.0;          ///< of bodies
  std::vector<Light> lights = {};  ///< beside the sun, at the time that is shown
  std::vector<std::shared_ptr<const RgbaImage>> pictures = {};  ///< of the highlights of meshes
};

inline constexpr std::size_t most_lights = 63;

/// Slopes that a picture must not draw one by one.
struct HiddenSlopes {
  /// [cascade][level]: what the mip levels of its slope map hide.
  std::vector<std::vector<ocean::SlopeCovariance>> cascades;
  /// All slopes of the Gerstner waves, for grids too coarse to draw them.
  ocean::SlopeCovariance gerstner_waves;
  /// Of ripples that neither cascades nor Gerstner waves have.
  ocean::SlopeCovariance ripples;
};

/// All simulations of a scene on one device with one queue, and the time that they share. What they make
/// stays on the device until somebody asks. Objects are confined to the thread that made them.
class World {
 public:
  /// Throws what the simulations throw for parameters out of range.
  World(const ocl::Device& device, const WorldParameters& parameters);

  const ocl::Device& device() const { return device_; }
  const WorldParameters& parameters() const { return parameters_; }
  double time_s() const { return time_s_; }

  /// Enqueues the world of this time, as seen from this height: sky, sea, foam, clouds.
  void at(double time_s, double eye_height_m);
  /// Where the eye is at the next at(): wakes may be about it.
  void set_eye(const ocean::WaterPoint& eye) { eye_ = eye; }
  /// Enqueues what a camera sees of the ground, if there is any, in the light of the last at(). An eye that
  /// is farther from the map than rays reach sees nothing of it. Throws what WorldTerrain::at() throws.
  void see_terrain(const Camera& camera, const terrain::Sampling& sampling = {},
                   TileWait wait = TileWait::all);
  /// Enqueues what the sea, as if it were level, mirrors of the ground, as the mirrored camera sees it
  /// (offing::mirrored()), in the light of the last at(). Does nothing in a world without either.
  void see_mirrored_terrain(const Camera& mirrored);
  /// Enqueues what this camera, with the eye of the last see_terrain(), would see of the ground if there were
  /// no water before it, as deep as water lets light through. Does nothing in a world without either.
  void see_terrain_beneath(const Camera& camera);
  /// From now on the sea has at most so many samples a side, a power of two from 16 on: of waves too short
  /// for them the ripples have the slopes. Bodies float on the whole sea still. Throws what Ocean throws.
  void set_sea_samples(int most);
  /// See WorldWakes::set_most_steps(); of wakes that are yet to come too.
  void set_most_wake_steps(int most);
  /// See WorldClouds::set_particle_halvings(); of clouds that are yet to come too. Throws
  /// Error(bad_usage) for halvings out of range.
  void set_cloud_halvings(int halvings);
  /// Takes effect with the next at().
  void set_light_lag(const LightLag& lag);
  /// Enqueues what a camera sees of the clouds of the last at(), if there are any: WorldClouds::see().
  void see_clouds(const Camera& camera);
  /// The same for what the sea mirrors: WorldClouds::see_mirrored().
  void see_mirrored_clouds(const Camera& mirrored);
  /// Takes the meshes to the time of the last at(), with the highlights that they have for this eye. With a
  /// lighting, of the world's axes at any time, these depend on the time and on that of the sequence's first
  /// picture alone (WorldMesh::at()); without one they follow the eye and the lights as they are
  /// (WorldMesh::follow()).
  void see_meshes(const glm::dvec3& eye_m, const highlights::LightingAt& lighting_at = {},
                  std::optional<double> first_s = {});

  /// The water at points of the world by the last at(), its heights above sea_level_m: Ocean::sample().
  /// Throws what ocean() throws.
  std::vector<ocean::WaterSample> sample(std::span<const ocean::WaterPoint> points,
                                         const ocean::WaterQuery& query = {}) {
    return ocean().sample(points, query);
  }

  /// The same in parts, without memory for all of them.
  void sample(std::span<const ocean::WaterPoint> points, const ocean::TakeSamples& take,
              const ocean::WaterQuery& query = {}) {
    ocean().sample(points, take, query);
  }
  /// The same for points and samples on the device: Ocean::sample().
  void sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
              ocl::Buffer<ocean::WaterSample>& samples, const ocean::WaterQuery& query = {}) {
    ocean().sample(points, count, samples, query);
  }
  void sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
              ocl::Buffer<ocean::FirstWaterFloats>& samples, const ocean::WaterQuery& query = {}) {
    ocean().sample(points, count, samples, query);
  }

  // Changes while it runs. All take effect with the next at(), which then gives what a world made with the
  // changed parameters gives; one that throws has changed nothing, but reseed(), after which a failed device
  // needs a new world.

  /// Turns the sun.
  void set_sun(const sky::Sun& sun);
  /// Changes the air: its tables are made anew.
  void set_atmosphere(const sky::Atmosphere& atmosphere);
  /// Changes Gerstner waves, swells and raindrops; costs nothing but over shoals, a millisecond. Throws what
  /// require_valid_gerstner_waves() throws.
  void set_gerstner_waves(const ocean::GerstnerSea& gerstner_waves);
  /// Makes the wakes anew, without a history. Throws what WorldWakes throws.
  void set_wakes(const std::vector<WakeSettings>& wakes);
  /// Draws another sea of the same spectrum. Gerstner waves are drawn from it by the same seed: give those of
  /// the new one.
  void reseed(std::uint64_t seed, const ocean::GerstnerSea& gerstner_waves);
  /// Changes spectrum, grid, foam, wind and Gerstner waves to these parameters' own: the sea is made anew, or
  /// taken away. Leaves sun, air and ground.
  void set_sea(const WorldParameters& parameters);
  /// Changes the colour and the clearness of the water.
  void set_water(ocean::WaterType water) { parameters_.water = water; }
  /// Raises or lowers the sea and what floats on it.
  void set_sea_level(double level_m);
  /// Changes the ground; other heights or another place make it anew. Throws what WorldTerrain throws.
  void set_terrain(const std::optional<TerrainParameters>& terrain);
  /// Changes the clouds: those whose parameters stay are kept. Throws what WorldClouds throws.
  void set_clouds(const std::optional<CloudSkyParameters>& clouds);
  /// Puts other meshes in their place, made anew. Throws what WorldMesh throws.
  void set_meshes(const std::vector<MeshParameters>& meshes);
  /// Puts other bodies on the water, at their start at the time of the last at(); `before` has for each the
  /// number of the body so far that it is, which goes on from where it is then, or none. Empty, or at time 0:
  /// none does. Throws what WorldBodies throws.
  void set_bodies(const std::vector<BodySettings>& bodies, double run_up_s,
                  const std::vector<std::optional<std::size_t>>& before = {});
  /// The bodies with their history, for keep_bodies(); none in a world without bodies.
  std::shared_ptr<WorldBodies> shared_bodies() const { return bodies_; }
  /// Replaces the bodies by those of an earlier world with the same parameters, which go on where they are.
  void keep_bodies(std::shared_ptr<WorldBodies> bodies);
  /// The same bodies where they are now, whose meshes have other numbers.
  void renumber_body_meshes(const std::vector<BodySettings>& bodies);
  /// Throws Error(bad_usage) for more than most_lights.
  void set_lights(const std::vector<Light>& lights);
  /// Changes what the textures of highlights are made of.
  void set_images(std::vector<std::shared_ptr<const RgbaImage>> pictures) {
    parameters_.pictures = std::move(pictures);
  }

  /// nullptr in a world without bodies.
  const WorldBodies* bodies() const { return bodies_.get(); }
  /// From the next at() on, forces on the bodies of all times are kept, for bodies()->forces().
  void keep_forces_on_bodies() {
    if (bodies_) bodies_->keep_forces(true);
  }
  /// nullptr in a world without wakes.
  const WorldWakes* wakes() const { return wakes_ ? &*wakes_ : nullptr; }
  bool has_sea() const { return ocean_.has_value(); }
  /// Samples along a patch of the sea that there is, 0 without one.
  int sea_samples() const { return ocean_ ? ocean_->parameters().size : 0; }
  /// Throws Error(bad_usage) in a world without a sea.
  ocean::Ocean& ocean();
  /// nullptr in a world without ground.
  const WorldTerrain* terrain() const { return terrain_ ? &*terrain_ : nullptr; }
  WorldTerrain* terrain() { return terrain_ ? &*terrain_ : nullptr; }
  /// nullptr in a world without clouds.
  const WorldClouds* clouds() const { return clouds_ ? &*clouds_ : nullptr; }
  const std::vector<WorldMesh>& meshes() const { return meshes_; }
  /// In the order of the parameters.
  std::vector<WorldMesh>& meshes() { return meshes_; }
  /// What lights the meshes for this eye: the lights in their order and, while it is up, the sun.
  highlights::Lighting lighting(const glm::dvec3& eye_m) const;
  /// Of the still sea.
  double sea_level_m() const { return parameters_.sea_level_m; }
  const sky::ClearSky& sky() const { return sky_; }
  /// Light at the eye, by the last at().
  const sky::Illuminance& illuminance() const { return illuminance_; }
  const HiddenSlopes& hidden_slopes() const { return hidden_slopes_; }

  /// What the ground leaves of the waves; none where the sea is open: without ground, with ground that is too
  /// deep to be felt, or where waves are not to shoal.
  const std::shared_ptr<const ocean::Shoals>& shoals() const { return shoals_; }

  /// Water that washes up and down the shores, for pictures only; none where the sea is open or no waterline
  /// crosses the ground.
  const std::optional<ocean::Swash>& swash() const { return swash_; }

  /// The farthest that waves move the surface at the time of the last at(), 0 without a sea: six standard
  /// deviations of the cascades, which one sample in 10^8 exceeds, all Gerstner waves at once, and the eight
  /// tallest rings; over shoals, as high as the highest of them make waves, and the swash besides.
  ocean::SurfaceReach reach() const;

 private:
  void make_sea(const WorldParameters& parameters);
  /// To the samples that are wanted.
  void fit_sea(const WorldParameters& parameters);
  void make_shoals();
  BodySea body_sea() const {
    return {parameters_.spectrum, parameters_.ocean, parameters_.wind, shoals_, parameters_.sea_level_m};
  }
  void move_meshes_with_bodies();
  /// Removes relief of the ground where meshes stand on it, so that none floats or sinks.
  void level_ground_below_meshes();
  void look_at_sky(double eye_height_m);
  /// On the ground that this camera sees.
  TerrainLight light_on_terrain(const Camera& camera) const;
  std::optional<terrain::CloudShade> shade_of_clouds(const Camera& camera) const;
  void light_clouds(double time_s);

  ocl::Device device_;
  WorldParameters parameters_;
  int most_samples_ = std::numeric_limits<int>::max();
  std::optional<ocean::Ocean> ocean_, spare_ocean_;  // as it is, and as it was before of other samples
  std::vector<ocean::ShoalingBand> cascade_bands_;   // of ocean_
  std::shared_ptr<const ocean::DepthMap> bed_;       // of terrain_; none: not made yet
  std::shared_ptr<const ocean::Shoals> shoals_;
  std::optional<ocean::Swash> swash_;
  std::shared_ptr<WorldBodies> bodies_;
  std::optional<WorldWakes> wakes_;
  int most_wake_steps_ = 0;
  ocean::WaterPoint eye_;
  sky::ClearSky sky_;
  std::optional<WorldTerrain> terrain_;
  LightLag lag_;
  int cloud_halvings_ = 0;
  std::optional<WorldClouds> clouds_;
  std::optional<sky::ClearSky> cloud_sky_;                     // as clouds see it, not the eye
  std::vector<clouds::CloudIllumination> cloud_illumination_;  // one a cloud; none: it is out of date
  std::vector<WorldMesh> meshes_;
  TerrainLight terrain_light_{};  // of the sky's tables
  double time_s_ = 0.0;
  std::optional<double> sky_altitude_m_;  // of the sky's tables; none: they are out of date
  sky::Illuminance illuminance_;
  HiddenSlopes hidden_slopes_;
  double deviation_m_ = 0.0;  // of the cascades' heights
  double travel_rad_ = 0.0;   // mean direction of the sea
};

}  // namespace offing::world
