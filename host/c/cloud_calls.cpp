#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/c/arrays.h"
#include "host/c/handles.h"
#include "host/clouds/image/billboard_textures.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_renderer.h"

using offing::Error;
using offing::ErrorKind;
using offing::c::require;
using offing::c::require_count;
using offing::c::run;
using offing::c::Use;
using offing::c::vector_at;
using offing::c::write_values;
using offing::c::write_vector;

namespace {

/// Throws Error(bad_input) for values out of range.
offing::Camera camera_of(const OffingCamera& given) {
  const offing::Camera camera{.eye_m = vector_at(given.eye_m, 0),
                              .yaw_rad = given.yaw_rad,
                              .pitch_rad = given.pitch_rad,
                              .roll_rad = given.roll_rad,
                              .vertical_field_of_view_rad = given.vertical_field_of_view_rad,
                              .width_px = given.width_px,
                              .height_px = given.height_px};
  offing::require_valid(camera);
  constexpr int longest_px = offing::scene::longest_picture_px;
  if (std::max(camera.width_px, camera.height_px) > longest_px) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("camera: expected sides within [1, {}], got {} x {}", longest_px, camera.width_px,
                            camera.height_px),
                "ask for a size such as 1280 x 720");
  }
  return camera;
}

std::size_t count_of_particles(const OffingWorld& world) {
  const offing::world::WorldClouds* clouds = world.world.clouds();
  return clouds == nullptr ? 0 : clouds->count();
}

/// Of the last frame, relative to the sky's origin.
std::vector<CloudParticle> particles_of(const offing::world::WorldClouds& clouds) {
  std::vector<CloudParticle> particles = clouds.particles().read();
  particles.resize(clouds.count());
  return particles;
}

void write_particle(const OffingCloudParticles& arrays, std::size_t index, const CloudParticle& particle,
                    const glm::dvec3& origin_m) {
  write_vector(arrays.place_m, index, origin_m + glm::dvec3(particle.x, particle.y, particle.z));
  write_values(arrays.radius_m, index, {particle.radius});
  write_values(arrays.optical_mass_m2, index, {particle.optical_mass});
  write_values(arrays.albedo, index, {particle.red, particle.green, particle.blue});
  write_values(arrays.cloud, index, {std::uint32_t{particle.cloud}});
  write_values(arrays.id, index, {std::uint32_t{particle.id}});
}

/// The extinction of the last frame's particles, made again if the frame or the cells changed; nullptr
/// where there is none.
const offing::clouds::VolumeMedium* extinction_of(OffingWorld& world, double cell_m) {
  const offing::world::WorldClouds* clouds = world.world.clouds();
  if (clouds == nullptr) return nullptr;
  std::optional<OffingWorld::CloudExtinction>& kept = world.cloud_extinction;
  const double time_s = world.world.time_s();
  if (!kept || kept->time_s != time_s || kept->cell_m != cell_m) {
    offing::CloudVolume volume =
        offing::clouds::rasterised(world.world.device(), particles_of(*clouds), cell_m);
    volume.origin_m += clouds->sky_origin_m();
    kept.emplace(OffingWorld::CloudExtinction{});
    if (!volume.density.empty()) kept->medium.emplace(volume);
    // Last, so that a medium that could not be made is not taken for clear sky later.
    kept->time_s = time_s;
    kept->cell_m = cell_m;
  }
  return kept->medium ? &*kept->medium : nullptr;
}

/// Enqueues what the camera sees of the clouds of the last frame.
const offing::clouds::CloudImage& drawn_clouds(OffingWorld& world, const offing::Camera& camera) {
  const offing::world::WorldClouds& clouds = *world.world.clouds();
  if (!world.cloud_image) {
    const auto own = offing::scene::own_billboards(world.scene);
    world.cloud_image.emplace(world.world.device(), own ? *own : offing::clouds::billboard_textures());
  }
  offing::clouds::CloudImage& image = *world.cloud_image;
  image.fit(camera.width_px, camera.height_px);
  world.world.see_clouds(camera);
  const auto& [x, y, z] = world.world.parameters().sun.sun_direction;
  image.draw({.particles = clouds.particles(),
              .sprites = clouds.sprites(),
              .order = clouds.order(),
              .count = clouds.count(),
              .origin_m = clouds.sky_origin_m(),
              .sun_direction = {x, y, z},
              .resolved = clouds.resolved()},
             camera);
  return image;
}

/// Rows from the bottom up, as images have them, to rows from the top down.
template <class Pixel, class Number>
void write_rows(const std::vector<Pixel>& pixels, const offing::Camera& camera, Number* target) {
  constexpr std::size_t channels = sizeof(Pixel) / sizeof(Number);
  const auto width = static_cast<std::size_t>(camera.width_px),
             height = static_cast<std::size_t>(camera.height_px);
  const auto* from = reinterpret_cast<const Number*>(pixels.data());
  for (std::size_t row = 0; row < height; ++row)
    std::copy_n(from + (height - 1 - row) * width * channels, width * channels,
                target + row * width * channels);
}

}  // namespace

size_t offing_cloud_count(const OffingWorld* world) {
  if (world == nullptr || world->world.clouds() == nullptr) return 0;
  return world->world.clouds()->parameters().clouds.size();
}

size_t offing_cloud_particle_count(const OffingWorld* world) {
  return world == nullptr ? 0 : count_of_particles(*world);
}

OffingStatus offing_read_cloud_particles(OffingWorld* world, size_t count,
                                         const OffingCloudParticles* particles) {
  return run([&] {
    const Use use(world, "world");
    require_count("count", count, count_of_particles(*world));
    if (count == 0) return;
    require(particles, "particles");
    const OffingCloudParticles wanted = offing::c::read_struct(particles, "particles");
    const offing::world::WorldClouds& clouds = *world->world.clouds();
    const std::vector<CloudParticle> found = particles_of(clouds);
    for (std::size_t i = 0; i < count; ++i) write_particle(wanted, i, found[i], clouds.sky_origin_m());
  });
}

OffingStatus offing_sample_clouds(OffingWorld* world, double cell_m, const double* points_m, size_t count,
                                  double* extinction_per_m) {
  return run([&] {
    const Use use(world, "world");
    if (count == 0) return;
    require(points_m, "points_m");
    require(extinction_per_m, "extinction_per_m");
    const offing::clouds::VolumeMedium* medium = extinction_of(*world, cell_m);
    for (std::size_t i = 0; i < count; ++i)
      extinction_per_m[i] = medium == nullptr ? 0.0 : medium->extinction(vector_at(points_m, i));
  });
}

OffingStatus offing_get_camera(OffingWorld* world, OffingCamera* camera) {
  return run([&] {
    const Use use(world, "world");
    const offing::Camera& found = world->camera;
    OffingCamera values{};
    values.size = sizeof values;
    write_vector(values.eye_m, 0, found.eye_m);
    values.yaw_rad = found.yaw_rad;
    values.pitch_rad = found.pitch_rad;
    values.roll_rad = found.roll_rad;
    values.vertical_field_of_view_rad = found.vertical_field_of_view_rad;
    values.width_px = found.width_px;
    values.height_px = found.height_px;
    offing::c::write_struct(camera, "camera", values);
  });
}

OffingStatus offing_draw_clouds(OffingWorld* world, const OffingCamera* camera, float* rgba_kcdpm2,
                                float* distance_m, size_t count) {
  return run([&] {
    const Use use(world, "world");
    require(camera, "camera");
    const offing::Camera seen_by = camera_of(offing::c::read_struct(camera, "camera"));
    const std::size_t pixels =
        static_cast<std::size_t>(seen_by.width_px) * static_cast<std::size_t>(seen_by.height_px);
    require_count("count", count, pixels);
    if (world->world.clouds() == nullptr) {
      if (rgba_kcdpm2 != nullptr) std::fill_n(rgba_kcdpm2, 4 * pixels, 0.0f);
      if (distance_m != nullptr) std::fill_n(distance_m, pixels, 0.0f);
      return;
    }
    const offing::clouds::CloudImage& drawn = drawn_clouds(*world, seen_by);
    if (rgba_kcdpm2 != nullptr) write_rows(drawn.image().read(), seen_by, rgba_kcdpm2);
    if (distance_m != nullptr) write_rows(drawn.distance_m().read(), seen_by, distance_m);
  });
}
