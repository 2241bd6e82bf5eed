#include "host/scene/prepare/cloud_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "host/base/camera.h"
#include "host/clouds/particles/cloud_particle.h"
#include "host/clouds/shape/mesh_volume.h"
#include "host/io/clouds/cloud_particles.h"
#include "host/io/meshes/read_mesh.h"
#include "host/io/text/text_mesh.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {

namespace {

using clouds::CloudParameters;

/// Tells faults of what `make` makes at the place of a key.
template <typename Make>
auto at_key(const Scene& scene, const ValueKey& key, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", place_of_name(scene, key), error.what()), error.hint());
  }
}

/// The columns are the cloud's own axes in the scene. As with meshes, its -z axis is where it looks. A file
/// whose z axis points up is turned to y up first.
glm::dmat3 turn_of(const CloudShapeScene& shape) {
  const CameraBasis axes =
      basis({.yaw_rad = shape.yaw_rad, .pitch_rad = shape.pitch_rad, .roll_rad = shape.roll_rad});
  const bool is_laid = !shape.file.empty() && shape.up == CloudUp::z;
  return is_laid ? glm::dmat3(axes.right, axes.forward, axes.up)
                 : glm::dmat3(axes.right, axes.up, -axes.forward);
}

/// Where the axes of a volume's cells go by quarter turns.
struct QuarterTurn {
  std::array<int, 3> from{0, 1, 2};   ///< which axis comes to lie along x, y, z
  std::array<bool, 3> is_mirrored{};  ///< and runs the other way

  bool operator==(const QuarterTurn&) const = default;
};

QuarterTurn quarter_turn(const Scene& scene, std::size_t index) {
  const glm::dmat3 turn = turn_of(scene.clouds[index].shape);
  constexpr double tolerance = 1e-9;
  QuarterTurn quarters;
  for (int from = 0; from < 3; ++from) {
    for (int to = 0; to < 3; ++to) {
      const double share = std::abs(turn[from][to]);
      if (share > 1.0 - tolerance) {
        quarters.from[static_cast<std::size_t>(to)] = from;
        quarters.is_mirrored[static_cast<std::size_t>(to)] = turn[from][to] < 0.0;
      } else if (share > tolerance) {
        throw Error(
            ErrorKind::bad_input,
            fmt::format("{}: expected yaw_deg, pitch_deg and roll_deg of 0, 90, 180 or 270 for a .vdb, "
                        "found another turn",
                        place_of_name(scene, {"cloud.file", {index, 0}})),
            "a .vdb has only quarter turns: turn it in the program that wrote it, or write up = "
            "\"z\" if it lies on its side");
      }
    }
  }
  return quarters;
}

/// The values of all bricks, each brick turned.
template <typename Value>
std::vector<Value> turned_cells(const std::vector<Value>& values, const QuarterTurn& turn) {
  constexpr int edge = CloudVolume::brick_cells;
  constexpr std::array<int, 3> step{1, edge, edge * edge};
  std::vector<Value> turned(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto cell = static_cast<int>(i % CloudVolume::cells_of_brick);
    int from = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int place = cell / step[axis] % edge;
      from += step[static_cast<std::size_t>(turn.from[axis])] *
              (turn.is_mirrored[axis] ? edge - 1 - place : place);
    }
    turned[i] = values[i - static_cast<std::size_t>(cell) + static_cast<std::size_t>(from)];
  }
  return turned;
}

void turn_volume(const QuarterTurn& turn, VdbCloud& cloud) {
  if (turn == QuarterTurn{}) return;
  const CloudVolume& given = cloud.volume;
  CloudVolume turned{.cell_m = given.cell_m,
                     .extinction_per_m = given.extinction_per_m,
                     .brick_of = {},
                     .density = turned_cells(given.density, turn)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int to = static_cast<int>(axis), from = turn.from[axis];
    turned.bricks[axis] = given.bricks[static_cast<std::size_t>(from)];
    const double low_m = given.origin_m[from],
                 high_m = low_m + given.cell_m * CloudVolume::brick_cells * turned.bricks[axis];
    turned.origin_m[to] = turn.is_mirrored[axis] ? -high_m : low_m;
  }
  const std::array<int, 3> step{1, given.bricks[0], given.bricks[0] * given.bricks[1]};
  const auto [nx, ny, nz] = turned.bricks;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const std::array<int, 3> place{i % nx, i / nx % ny, i / nx / ny};
    int from = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from += step[static_cast<std::size_t>(turn.from[axis])] *
              (turn.is_mirrored[axis] ? turned.bricks[axis] - 1 - place[axis] : place[axis]);
    }
    turned.brick_of.push_back(given.brick_of[static_cast<std::size_t>(from)]);
  }
  cloud.volume = std::move(turned);
  cloud.albedo = turned_cells(cloud.albedo, turn);
}

/// The particles of a .ply, all of this cloud, with its colour where the scene gives one.
RestingParticles particles_of(const Scene& scene, std::size_t index) {
  const CloudScene& cloud = scene.clouds[index];
  ParticleCloud file = read_named(scene, {"cloud.file", {index, 0}}, "particles of a cloud", cloud.shape.file,
                                  [&] { return read_cloud_particles(cloud.shape.file); });
  const glm::dmat3 turn = turn_of(cloud.shape);
  const auto scale = static_cast<float>(cloud.scale);
  for (CloudParticle& particle : file.particles) {
    const glm::vec3 place_m(cloud.scale *
                            (turn * (glm::dvec3(particle.x, particle.y, particle.z) + file.origin_m)));
    particle.x = place_m.x;
    particle.y = place_m.y;
    particle.z = place_m.z;
    particle.radius *= scale;
    particle.optical_mass *= scale * scale;  // extinction over the volume, as thick for light as before
    at_key(scene, {"cloud.file", {index, 0}}, [&] {
      clouds::require_valid(particle, static_cast<std::size_t>(&particle - file.particles.data()));
    });
    if (cloud.look.albedo) {
      particle.red = static_cast<float>(cloud.look.albedo->x);
      particle.green = static_cast<float>(cloud.look.albedo->y);
      particle.blue = static_cast<float>(cloud.look.albedo->z);
    }
  }
  return std::make_shared<const std::vector<CloudParticle>>(std::move(file.particles));
}

/// Sampled as a volume of balls is (C5), from the cells of the file.
void take_volume(const Scene& scene, std::size_t index, CloudParameters& parameters) {
  const CloudScene& cloud = scene.clouds[index];
  VdbCloud file = read_named(scene, {"cloud.file", {index, 0}}, "a volume", cloud.shape.file,
                             [&] { return read_vdb(cloud.shape.file, cloud.shape.grid); });
  turn_volume(quarter_turn(scene, index), file);
  file.volume.origin_m *= cloud.scale;
  file.volume.cell_m *= cloud.scale;
  if (file.tells_extinction && !cloud.look.extinction_per_m) {
    parameters.look.extinction_per_m = file.volume.extinction_per_m;
  }
  file.volume.extinction_per_m = parameters.look.extinction_per_m;
  parameters.modelling = clouds::Modelling::sampled;
  // What has been frayed already is taken as it is, unless the scene says otherwise.
  if (!cloud.noise.blend) parameters.turbulence.blend = 0.0;
  if (!cloud.noise.wisp) parameters.turbulence.wisp = 1.0;
  const bool is_frayed = parameters.turbulence.blend > 0.0 || parameters.turbulence.wisp != 1.0;
  if (!cloud.look.albedo) file.volume.albedo = std::move(file.albedo);
  parameters.takes_cells_of_shape = !is_frayed;
  parameters.shape = std::make_shared<const CloudVolume>(std::move(file.volume));
}

/// A mesh whose longest edge of the box around it is as long as asked, about its middle.
TriangleMesh fitted(TriangleMesh mesh, double size_m) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec3& place_m : mesh.positions_m) {
    low = glm::min(low, place_m);
    high = glm::max(high, place_m);
  }
  const glm::dvec3 extent_m = high - low, middle_m = 0.5 * (low + high);
  const double longest_m = std::max({extent_m.x, extent_m.y, extent_m.z});
  if (!(longest_m > 0.0 && std::isfinite(longest_m))) {
    throw Error(ErrorKind::bad_input,
                fmt::format("cloud shape: expected a mesh that encloses a volume, found one {:g} m long",
                            mesh.positions_m.empty() ? 0.0 : longest_m),
                "check the mesh with `offing-mesh check`");
  }
  const double scale = size_m / longest_m;
  for (glm::dvec3& place_m : mesh.positions_m) place_m = scale * (place_m - middle_m);
  return mesh;
}

void take_solid(const CloudScene& cloud, TriangleMesh mesh, CloudParameters& parameters) {
  const CloudShapeScene& shape = cloud.shape;
  const glm::dmat3 turn = turn_of(shape);
  for (glm::dvec3& place_m : mesh.positions_m) place_m = turn * place_m;
  // Fine enough for the rise of density from the surface, and no finer than the size can show.
  constexpr double most_cells = 192.0, cells_of_rise = 3.0;
  const double rise_m = cloud.scale * (shape.thickness_m + shape.fluff_m);
  const double cell_m = std::max(rise_m / cells_of_rise, cloud.scale * shape.size_m / most_cells);
  const double size_m = cloud.scale * shape.size_m;
  if (rise_m / cells_of_rise > size_m) {
    throw Error(ErrorKind::bad_input,
                fmt::format("cloud shape: {:g} m is too small for density that rises over {:g} m, the sum of "
                            "thickness_m and fluff_m",
                            size_m, rise_m),
                "lower cloud.thickness_m and cloud.fluff_m, or raise cloud.size_m");
  }
  CloudVolume volume;
  try {
    volume = clouds::mesh_volume(mesh, {.cell_m = cell_m,
                                        .thickness_m = cloud.scale * shape.thickness_m,
                                        .fluff_m = cloud.scale * shape.fluff_m});
  } catch (const Error& error) {
    // Cells are no key of a scene: they follow from these.
    throw Error(error.kind(), error.what(),
                "lower cloud.thickness_m and cloud.fluff_m, raise cloud.size_m, or check the mesh "
                "(`offing-mesh check`)");
  }
  volume.extinction_per_m = parameters.look.extinction_per_m;
  parameters.modelling = clouds::Modelling::sampled;
  parameters.shape = std::make_shared<const CloudVolume>(std::move(volume));
}

/// What makes a cloud is said once: the rest would be ignored.
void require_one_source(const Scene& scene, std::size_t index) {
  const CloudShapeScene& shape = scene.clouds[index].shape;
  const std::pair<const char*, bool> sources[]{{"cloud.file", !shape.file.empty()},
                                               {"cloud.mesh", !shape.mesh.empty()},
                                               {"cloud.text", !shape.text.empty()},
                                               {"cloud.shape", shape.solid.has_value()}};
  const char* first = nullptr;
  for (const auto& [key, is_given] : sources) {
    if (!is_given) continue;
    if (first != nullptr) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected one of cloud.file, cloud.mesh, cloud.text and cloud.shape, found {} too",
                      place_of_name(scene, {key, {index, 0}}), first),
          "leave one of them out");
    }
    first = key;
  }
}

}  // namespace

RestingParticles take_shape(const Scene& scene, std::size_t index, CloudParameters& parameters) {
  const CloudScene& cloud = scene.clouds[index];
  if (!cloud.shape.is_given()) return nullptr;
  require_one_source(scene, index);
  const ElementIndex element{index, 0};
  const double size_m = cloud.scale * cloud.shape.size_m;
  if (cloud.shape.file.empty()) {
    if (!cloud.shape.mesh.empty()) {
      const TriangleMesh mesh = read_named(scene, {"cloud.mesh", element}, "a mesh", cloud.shape.mesh, [&] {
        return fitted(read_mesh(cloud.shape.mesh, scene.trust), size_m);
      });
      at_key(scene, {"cloud.mesh", element}, [&] { take_solid(cloud, mesh, parameters); });
    } else if (!cloud.shape.text.empty()) {
      at_key(scene, {"cloud.text", element}, [&] {
        const TextMeshOptions options{.height_m = size_m, .thickness_m = cloud.scale * cloud.shape.depth_m};
        take_solid(cloud, text_mesh(cloud.shape.text, options), parameters);
      });
    } else if (cloud.shape.solid) {
      constexpr int detail = 2;
      at_key(scene, {"cloud.shape", element}, [&] {
        const mesh_shapes::ShapeRow& row = mesh_shapes::closed_shapes().at(*cloud.shape.solid);
        take_solid(cloud, fitted(mesh_shapes::made_shape(row, 1.0, detail).mesh, size_m), parameters);
      });
    }
    return nullptr;
  }
  const std::filesystem::path extension = std::filesystem::path(cloud.shape.file).extension();
  if (extension == ".vdb") {
    take_volume(scene, index, parameters);
    return nullptr;
  }
  if (extension == ".ply") return particles_of(scene, index);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a .vdb or a .ply, got {}",
                          place_of_name(scene, {"cloud.file", {index, 0}}), cloud.shape.file),
              "write volumes as .vdb and particles as .ply");
}

}  // namespace offing::scene
