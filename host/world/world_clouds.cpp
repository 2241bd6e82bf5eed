#include "host/world/world_clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/clouds/light/particle_light.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/clouds/particles/particle_order.h"
#include "host/clouds/particles/particle_thinning.h"

namespace offing::world {
namespace {

using clouds::CloudModel;
using clouds::CloudMotion;
using clouds::CloudParameters;

/// Between the clouds at time 0, where floats are finest.
glm::dvec3 origin_of(const std::vector<CloudParameters>& clouds) {
  constexpr double step_m = 1024.0;  // multiples of it are exact in floats
  glm::dvec3 low = clouds.front().position_m, high = low;
  for (const CloudParameters& cloud : clouds) {
    low = glm::min(low, cloud.position_m);
    high = glm::max(high, cloud.position_m);
  }
  return step_m * glm::floor(0.5 * (low + high) / step_m + 0.5);
}

bool stands_still(const CloudParameters& cloud) {
  const CloudMotion& motion = cloud.motion;
  return motion.wind_mps == glm::dvec3(0.0) && motion.sway_m == 0.0 && !motion.path && !motion.heat;
}

/// Whether all of them keep their distances while they drift, but for their eddies, shear and rise.
bool drift_as_one(const std::vector<CloudParameters>& clouds) {
  return std::all_of(clouds.begin(), clouds.end(), [&](const CloudParameters& cloud) {
    return !cloud.motion.path && !cloud.motion.obstacle &&
           cloud.motion.wind_mps == clouds.front().motion.wind_mps;
  });
}

/// The last time whose light is worked out.
double light_time_s(double step_s, double time_s) {
  return step_s > 0.0 ? step_s * std::floor(time_s / step_s) : time_s;
}

/// How far clouds go from one time to another, in their mean.
glm::dvec3 drift_m(const std::vector<CloudParameters>& clouds, double from_s, double to_s) {
  glm::dvec3 sum_m(0.0);
  for (const CloudParameters& cloud : clouds)
    sum_m += clouds::cloud_origin_m(cloud, to_s) - clouds::cloud_origin_m(cloud, from_s);
  return sum_m / static_cast<double>(clouds.size());
}

using Particles = std::shared_ptr<const std::vector<CloudParticle>>;

Particles given_particles(const CloudSkyParameters& parameters, std::size_t index) {
  return index < parameters.particles.size() ? parameters.particles[index] : nullptr;
}

/// The numbers of clouds that are not hidden: a hidden one is given no particles. If all are, all of them.
std::vector<std::size_t> drawn_clouds(const CloudSkyParameters& parameters) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < parameters.clouds.size(); ++i) {
    const Particles given = given_particles(parameters, i);
    if (!given || !given->empty()) drawn.push_back(i);
  }
  if (drawn.empty()) {
    drawn.resize(parameters.clouds.size());
    std::iota(drawn.begin(), drawn.end(), 0);
  }
  return drawn;
}

/// A cloud by how often its particles are halved; nullptr: not asked for yet.
using ModelLevels = std::array<std::shared_ptr<const CloudModel>, 1 + clouds::most_particle_halvings>;

void make_level(const ocl::Device& device, ModelLevels& levels, std::size_t halvings) {
  if (!levels[halvings])
    levels[halvings] =
        std::make_shared<const CloudModel>(levels[0]->thinned(device, static_cast<int>(halvings)));
}

/// Of all clouds.
std::uint64_t count_of(const std::vector<ModelLevels>& models, std::size_t halvings) {
  std::uint64_t count = 0;
  for (const ModelLevels& levels : models) count += levels[halvings]->count();
  return count;
}

/// All particles at a time.
struct Placed {
  std::optional<double> time_s;  // nothing: they are nowhere yet
  ocl::Buffer<CloudParticle> particles;
};

/// How far aside an eye and its mirror image may stand, rad as seen from any cloud, for water to mirror
/// clouds in the light that they send to the eye itself. Rays that water mirrors are as far aside anyway
/// where their waves slope by half as much; in a wind of 1 m/s they slope by 0.09 (Cox and Munk 1954).
constexpr double mirror_rad = 0.02;

/// Particles at a time, the light on them and what of them is marched.
struct LitClouds {
  explicit LitClouds(const ocl::Device& on) : device(on), billboards(on), resolved(on) {}

  /// From now on they are to be lit so, and by each other, by light_further(); of those that `like` marches
  /// now volumes are made too.
  void light(std::span<const clouds::CloudIllumination> lights,
             std::span<const clouds::CloudIllumination> with_others, std::uint32_t count,
             std::span<const clouds::CloudLook> looks, clouds::LightModel model,
             clouds::ParticleAlbedo albedo, const LitClouds& like) {
    by.clear();
    box.reset();
    resolved.clear();
    is_resolved = model != clouds::LightModel::calibrated;
    has_marched = !is_resolved && clouds::have_marched_cells(looks.size());
    if (has_marched && !marched) marched.emplace(device, clouds::LightCells::of_marched);
    billboards.start_relight(placed.particles, count, with_others, looks, model, albedo);
    if (has_marched) marched->start_relight(placed.particles, count, with_others, looks, model, albedo);
    to_march = like.resolved.marched();
    by.assign(lights.begin(), lights.end());
  }

  std::size_t steps_left() const {
    return billboards.steps_left() + (has_marched ? marched->steps_left() : 0) + (is_resolved ? 0 : 1) +
           to_march.size();
  }
  void light_further() {
    if (billboards.steps_left() > 0) {
      billboards.relight_further();
    } else if (has_marched && marched->steps_left() > 0) {
      marched->relight_further();
    } else if (!is_resolved) {
      resolved.set(placed.particles, has_marched ? *marched : billboards);
      is_resolved = true;
    } else if (!to_march.empty()) {
      resolved.make(to_march.back());
      to_march.pop_back();
    }
  }

  ocl::Device device;
  Placed placed;
  clouds::ParticleLight billboards;
  std::optional<clouds::ParticleLight> marched;  // in smaller cells; made when first needed
  bool has_marched = false, is_resolved = false;
  std::vector<int> to_march;  // whose volumes are still to be made
  clouds::ResolvedClouds resolved;
  std::vector<clouds::CloudIllumination> by;  // one a cloud; empty: no light
  std::optional<clouds::CloudBox> box;        // in this light; read when first needed
};

/// The light that particles send to an eye.
struct SentLight {
  std::optional<glm::dvec3> eye_m;  // from the lit particles' origin; nothing: not this light of these
  bool is_old = false;              // of a light before, which goes part by part
  int parts = 1, parts_left = 0;    // of the sprites: those left are still the light to an eye before
  ocl::Buffer<CloudSprite> sprites;
};

/// The particles in the order of their distances from an eye.
struct SeenOrder {
  explicit SeenOrder(const ocl::Device& device) : order(device) {}

  std::optional<glm::dvec3> eye_m;  // nothing: not of these particles
  clouds::ViewOrder order;
};

/// Whose light and order they are.
enum SeenBy : std::size_t { eye, mirror_image, seen_by_count };

}  // namespace

struct WorldClouds::Sky {
  explicit Sky(const ocl::Device& on)
      : device(on), lit(std::make_unique<LitClouds>(on)), orders{SeenOrder(on), SeenOrder(on)} {}

  bool is_elsewhere(double time_s, const Placed& placed) const {
    return !placed.time_s ||
           (*placed.time_s != time_s && !std::all_of(drawn.begin(), drawn.end(), stands_still));
  }

  /// Whether they were elsewhere.
  bool place(double time_s, Placed& placed) const {
    if (!is_elsewhere(time_s, placed)) return false;
    std::uint32_t first = 0;
    for (const ModelLevels& levels : models) {
      const CloudModel& model = *levels[halvings];
      model.at(time_s, origin_m, placed.particles, first);
      first += model.count();
    }
    placed.time_s = time_s;
    return true;
  }

  void forget_orders() {
    for (SeenOrder& of : orders) of.eye_m.reset();
  }

  void forget_light() {
    lit->by.clear();
    has_shadow = false;
    lit->box.reset();
    lit->resolved.clear();
    is_lighting = false;
    forget_sent_light();
  }

  /// Whether light that is there already may stay while another is worked out.
  bool keeps_light() const { return lag.cloud_light_frames > 1 && !lit->by.empty(); }

  /// From now on `next` is lit, of this time, while `lit` stays.
  void start_next(double time_s) {
    if (!next) next = std::make_unique<LitClouds>(device);
    if (next->placed.particles.size() != lit->placed.particles.size())
      next->placed.particles = {device, lit->placed.particles.size(), "lit particles of the sky"};
    place(time_s, next->placed);
    next->by.clear();
    is_lighting = true;
  }

  std::vector<clouds::CloudIllumination> with_others(std::span<const clouds::CloudIllumination> of_clouds,
                                                     double time_s) const {
    std::vector<clouds::CloudExtent> extents;
    for (std::size_t i = 0; i < models.size(); ++i) {
      extents.push_back(models[i][0]->extent());
      extents.back().middle_m += clouds::cloud_origin_m(drawn[i], time_s);
    }
    return clouds::with_light_of_others(of_clouds, extents, looks);
  }

  /// From where they are lit to where they are at shown_at_s; whether that is elsewhere than before.
  bool carry() {
    const glm::dvec3 before_m = carried_m;
    carried_m = drift_m(drawn, *lit->placed.time_s, shown_at_s);
    return carried_m != before_m;
  }

  void light(LitClouds& clouds, std::span<const clouds::CloudIllumination> of_clouds) {
    const bool has_own_albedo = std::any_of(
        models.begin(), models.end(), [](const ModelLevels& levels) { return levels[0]->has_own_albedo(); });
    clouds.light(of_clouds, with_others(of_clouds, *clouds.placed.time_s), count, looks,
                 parameters.light_model,
                 has_own_albedo ? clouds::ParticleAlbedo::own : clouds::ParticleAlbedo::of_look, *lit);
  }

  /// The next part of the light of `next`; after the last it takes the place of `lit`.
  void light_further(std::span<const clouds::CloudIllumination> of_clouds) {
    if (takes_a_part_a_frame && !std::ranges::equal(next->by, of_clouds)) next->by.clear();
    if (next->by.empty()) {
      light(*next, of_clouds);
      const auto frames = static_cast<std::size_t>(lag.cloud_light_frames);
      takes_a_part_a_frame = lag.cloud_steps > 1 && std::ranges::equal(lit->by, of_clouds);
      steps_of_frame = takes_a_part_a_frame ? 1 : (next->steps_left() + frames - 1) / frames;
    }
    try {
      for (std::size_t i = 0; i < steps_of_frame && next->steps_left() > 0; ++i) next->light_further();
    } catch (...) {
      is_lighting = false;
      throw;
    }
    if (next->steps_left() > 0) return;
    std::swap(lit, next);
    carry();
    is_lighting = has_shadow = false;
    for (SentLight& sent : lights) sent.is_old = true, sent.parts_left = 0;
    forget_orders();
  }

  void forget_sent_light() {
    for (SentLight& light : lights) {
      light.eye_m.reset();
      light.is_old = false;
      light.parts_left = 0;
    }
  }

  /// Whether the lit particles are shown, carried along.
  bool carries() const { return is_one && lag.cloud_steps > 1; }
  const ocl::Buffer<CloudParticle>& shown_particles() const {
    return carries() ? lit->placed.particles : shown.particles;
  }
  glm::dvec3 shown_origin_m() const { return carries() ? origin_m + carried_m : origin_m; }

  /// Sends an eye the light that it lacks, or the next part of it: all parts go to one eye.
  void send(const glm::dvec3& eye_m, SentLight& light) {
    if (light.parts_left == 0) {
      if (light.eye_m && !light.is_old && are_within(lag.cloud_rad, eye_m, *light.eye_m)) return;
      light.parts = light.parts_left = light.eye_m ? lag.cloud_parts : 1;
      light.eye_m = eye_m;
      light.is_old = false;
    }
    const auto part = static_cast<std::uint32_t>(light.parts - light.parts_left);
    lit->billboards.see(glm::vec3(*light.eye_m), light.sprites,
                        {part, static_cast<std::uint32_t>(light.parts)});
    --light.parts_left;
  }

  /// Whether no particle sees the two, both from the lit particles' origin, farther apart than that.
  bool are_within(double angle_rad, const glm::dvec3& eye_m, const glm::dvec3& other_m) {
    if (angle_rad == 0.0) return eye_m == other_m;
    const std::optional<clouds::CloudBox>& box = lit_box();
    if (!box) return true;
    const glm::dvec3 nearest_m = glm::clamp(eye_m, glm::dvec3(box->low_m), glm::dvec3(box->high_m));
    return glm::distance(eye_m, other_m) <= angle_rad * glm::distance(eye_m, nearest_m);
  }

  const std::optional<clouds::CloudBox>& lit_box() {
    if (!lit->box) lit->box = lit->billboards.box();
    return lit->box;
  }

  void sort(const glm::dvec3& eye_m, SeenOrder& of) {
    if (of.eye_m == eye_m) return;
    of.order.sort(shown_particles(), count, glm::vec3(eye_m - shown_origin_m()));
    of.eye_m = eye_m;
  }

  bool is_resolved() const { return parameters.light_model == clouds::LightModel::calibrated; }

  glm::dvec3 from_lit_m(const glm::dvec3& eye_m) const { return eye_m - origin_m - carried_m; }

  ocl::Device device;
  CloudSkyParameters parameters;
  // Those of them that are not hidden, which alone have models, looks and lights, and their numbers there.
  std::vector<CloudParameters> drawn;
  std::vector<std::size_t> places;
  glm::dvec3 origin_m{0.0};
  std::vector<ModelLevels> models;       // one a cloud
  std::vector<clouds::CloudLook> looks;  // one a cloud
  std::size_t halvings = 0;              // of the particles
  std::uint32_t count = 0;               // of these
  Placed shown;                     // as of the last at(); with room for whole clouds, as those that are lit
  std::unique_ptr<LitClouds> lit;   // in the last light
  std::unique_ptr<LitClouds> next;  // in the one after; made when first needed
  bool is_lighting = false;         // `next` is under way
  std::size_t steps_of_frame = 0;   // of its light
  bool takes_a_part_a_frame = false;  // as it has the same illumination as `lit`
  LightLag lag;
  bool is_one = false;                           // the clouds drift as one
  double shown_at_s = 0.0;                       // of the last at()
  glm::dvec3 carried_m{0.0};                     // from `lit` to `shown`
  std::array<SentLight, seen_by_count> lights;   // to each of them
  std::array<SeenOrder, seen_by_count> orders;   // from each of them
  SeenBy light_of = eye, order_of = eye;         // what the last see() or see_mirrored() chose
  std::optional<clouds::CloudShadowMap> shadow;  // made when first asked for
  bool has_shadow = false;                       // of `lit`
};

WorldClouds::WorldClouds(const ocl::Device& device, const CloudSkyParameters& parameters)
    : sky_(std::make_unique<Sky>(device)) {
  set(parameters);
}
WorldClouds::WorldClouds(WorldClouds&&) noexcept = default;
WorldClouds& WorldClouds::operator=(WorldClouds&&) noexcept = default;
WorldClouds::~WorldClouds() = default;

const CloudSkyParameters& WorldClouds::parameters() const {
  return sky_->parameters;
}

void WorldClouds::set(const CloudSkyParameters& parameters) {
  Sky& sky = *sky_;
  if (parameters.clouds.empty()) {
    throw Error(ErrorKind::bad_usage, "clouds: expected at least one, found none", "add a cloud");
  }
  // All that can fail comes first.
  const CloudSkyParameters& before = sky.parameters;
  std::vector<ModelLevels> models;
  std::vector<CloudParameters> drawn;
  const std::vector<std::size_t> places = drawn_clouds(parameters);
  for (const std::size_t place : places) {
    const CloudParameters& cloud = drawn.emplace_back(parameters.clouds[place]);
    const Particles given = given_particles(parameters, place);
    const std::size_t i = models.size();
    const bool is_known =
        i < sky.models.size() && sky.drawn[i] == cloud && given_particles(before, sky.places[i]) == given;
    const auto number = static_cast<std::uint32_t>(i);
    if (is_known) {
      models.push_back(sky.models[i]);
    } else if (given) {
      models.push_back({std::make_shared<const CloudModel>(sky.device, cloud, *given, number)});
    } else {
      models.push_back({std::make_shared<const CloudModel>(sky.device, cloud, number)});
    }
    make_level(sky.device, models.back(), sky.halvings);
  }
  constexpr std::uint64_t most_particles = 0xffff'ffff;
  const std::uint64_t whole_count = count_of(models, 0);
  if (whole_count > most_particles) {
    throw Error(ErrorKind::out_of_memory, "clouds: more particles than can be counted", "ask for fewer");
  }
  const std::size_t room = std::max<std::size_t>(whole_count, 1);
  ocl::Buffer<CloudParticle> shown(sky.device, room, "particles of the sky");
  ocl::Buffer<CloudParticle> lit(sky.device, room, "lit particles of the sky");
  std::array<ocl::Buffer<CloudSprite>, seen_by_count> sprites;
  for (auto& of_light : sprites) of_light = ocl::Buffer<CloudSprite>(sky.device, room, "sprites of clouds");

  sky.models = std::move(models);
  sky.looks.clear();
  for (const CloudParameters& cloud : drawn) sky.looks.push_back(cloud.look);
  sky.shown = {.time_s = {}, .particles = std::move(shown)};
  sky.lit->placed = {.time_s = {}, .particles = std::move(lit)};
  sky.next.reset();
  for (std::size_t i = 0; i < sprites.size(); ++i) sky.lights[i].sprites = std::move(sprites[i]);
  sky.count = static_cast<std::uint32_t>(count_of(sky.models, sky.halvings));
  sky.parameters = parameters;
  sky.places = places;
  sky.drawn = std::move(drawn);
  sky.origin_m = origin_of(sky.drawn);
  sky.is_one = drift_as_one(sky.drawn);
  sky.forget_light();
  sky.forget_orders();
}

void WorldClouds::set_particle_halvings(int halvings) {
  clouds::require_halvings(halvings);
  Sky& sky = *sky_;
  const auto wanted = static_cast<std::size_t>(halvings);
  if (sky.halvings == wanted) return;
  for (ModelLevels& levels : sky.models) make_level(sky.device, levels, wanted);
  sky.halvings = wanted;
  sky.count = static_cast<std::uint32_t>(count_of(sky.models, wanted));
  sky.shown.time_s.reset();
  sky.lit->placed.time_s.reset();
  sky.next.reset();
  sky.forget_light();
  sky.forget_orders();
}

void WorldClouds::set_light_lag(const LightLag& lag) {
  Sky& sky = *sky_;
  if (sky.lag == lag) return;
  sky.lag = lag;
  sky.is_lighting = false;
  sky.forget_sent_light();
  sky.forget_orders();
}

void WorldClouds::at(double time_s) {
  Sky& sky = *sky_;
  const double light_at_s = light_time_s(sky.lag.cloud_steps * sky.parameters.light_step_s, time_s);
  if (!sky.keeps_light()) {
    if (sky.place(light_at_s, sky.lit->placed)) sky.forget_light();
  } else if (!sky.is_lighting && sky.is_elsewhere(light_at_s, sky.lit->placed)) {
    sky.start_next(light_at_s);
  }
  const bool has_moved = !sky.carries() && sky.place(time_s, sky.shown);
  sky.shown_at_s = time_s;
  if (sky.carry() || has_moved) sky.forget_orders();
}

void WorldClouds::light(std::span<const clouds::CloudIllumination> of_all) {
  Sky& sky = *sky_;
  if (of_all.size() != sky.parameters.clouds.size()) {
    throw Error(ErrorKind::bad_usage, fmt::format("light of clouds: expected {} illuminations, got {}",
                                                  sky.parameters.clouds.size(), of_all.size()));
  }
  if (sky.count == 0) return;
  std::vector<clouds::CloudIllumination> of_clouds;
  for (const std::size_t place : sky.places) of_clouds.push_back(of_all[place]);
  if (sky.is_lighting) {
    sky.light_further(of_clouds);
    return;
  }
  if (std::ranges::equal(sky.lit->by, of_clouds)) return;
  if (sky.keeps_light()) {
    sky.start_next(*sky.lit->placed.time_s);
    sky.light_further(of_clouds);
    return;
  }
  sky.forget_light();
  try {
    sky.light(*sky.lit, of_clouds);
    while (sky.lit->steps_left() > 0) sky.lit->light_further();
  } catch (...) {
    sky.forget_light();  // what is half made is no light
    throw;
  }
  sky.forget_orders();
}

void WorldClouds::light(const clouds::CloudIllumination& of_all) {
  light(std::vector<clouds::CloudIllumination>(sky_->parameters.clouds.size(), of_all));
}

void WorldClouds::see(const Camera& camera) {
  Sky& sky = *sky_;
  if (sky.lit->by.empty()) return;
  sky.light_of = sky.order_of = eye;
  sky.send(sky.from_lit_m(camera.eye_m), sky.lights[eye]);
  sky.sort(camera.eye_m, sky.orders[eye]);
  sky.lit->resolved.resolve(camera, sky.origin_m + sky.carried_m);
}

void WorldClouds::see_mirrored(const Camera& mirrored, double plane_m) {
  Sky& sky = *sky_;
  if (sky.lit->by.empty()) return;
  const glm::dvec3 image_m = sky.from_lit_m(mirrored.eye_m);
  const glm::dvec3 eye_m =
      sky.from_lit_m({mirrored.eye_m.x, 2.0 * plane_m - mirrored.eye_m.y, mirrored.eye_m.z});
  sky.light_of = sky.are_within(mirror_rad, eye_m, image_m) ? eye : mirror_image;
  sky.order_of = mirror_image;
  sky.send(sky.light_of == eye ? eye_m : image_m, sky.lights[sky.light_of]);
  sky.sort(mirrored.eye_m, sky.orders[mirror_image]);
  sky.lit->resolved.resolve(mirrored, sky.origin_m + sky.carried_m);
}

std::span<const clouds::CloudIllumination> WorldClouds::illumination() const {
  return sky_->lit->by;
}

void WorldClouds::cast_shadow() {
  Sky& sky = *sky_;
  if (sky.has_shadow) return;
  // The sun is the first one; others throw no shadows.
  const auto lit = std::find_if(sky.lit->by.begin(), sky.lit->by.end(), [](const auto& light) {
    return !light.suns.empty() && light.suns.front().illuminance_klx != glm::dvec3(0.0);
  });
  if (lit == sky.lit->by.end()) return;
  const std::optional<clouds::CloudBox>& box = sky.lit_box();
  if (!box) return;
  const glm::dvec3 low_m(box->low_m), high_m(box->high_m);
  const glm::dvec3 middle_m = 0.5 * (low_m + high_m);
  const double half_width_m = 0.5 * glm::length(high_m - low_m);
  if (!sky.shadow) sky.shadow.emplace(sky.device);
  sky.shadow->update(sky.lit->placed.particles, sky.count, lit->suns.front().direction, middle_m,
                     half_width_m);
  sky.has_shadow = true;
}

const clouds::CloudShadowMap* WorldClouds::shadow() const {
  return sky_->has_shadow ? &*sky_->shadow : nullptr;
}

CloudShadowParams WorldClouds::shadow_about(const glm::dvec3& point_m) const {
  if (shadow() == nullptr) return {};
  CloudShadowParams params = shadow()->params();
  const glm::dvec3 from = sky_->origin_m + sky_->carried_m - point_m;
  params.middle_x = static_cast<float>(params.middle_x + from.x);
  params.middle_y = static_cast<float>(params.middle_y + from.y);
  params.middle_z = static_cast<float>(params.middle_z + from.z);
  return params;
}

double WorldClouds::lit_at_s() const {
  const Sky& sky = *sky_;
  return (sky.is_lighting ? sky.next : sky.lit)->placed.time_s.value_or(0.0);
}

const ocl::Buffer<CloudParticle>& WorldClouds::particles() const {
  return sky_->shown_particles();
}
std::uint32_t WorldClouds::count() const {
  return sky_->count;
}
std::uint32_t WorldClouds::whole_count() const {
  return static_cast<std::uint32_t>(count_of(sky_->models, 0));
}
const ocl::Buffer<CloudSprite>& WorldClouds::sprites() const {
  return sky_->lights[sky_->light_of].sprites;
}
const ocl::Buffer<std::uint32_t>& WorldClouds::order() const {
  return sky_->orders[sky_->order_of].order.order();
}
clouds::ResolvedClouds* WorldClouds::resolved() const {
  return sky_->is_resolved() ? &sky_->lit->resolved : nullptr;
}
glm::dvec3 WorldClouds::sky_origin_m() const {
  return sky_->shown_origin_m();
}

}  // namespace offing::world
