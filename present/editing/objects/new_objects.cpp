#include "present/editing/objects/new_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/clouds/shape/genera.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/cloud_edits.h"
#include "present/editing/objects/pushed_value.h"
#include "present/editing/pointed_place.h"
#include "present/window/bookmarks.h"

namespace offing::present {
namespace {

using scene::Scene;

constexpr double farthest_new_m = 10e3;
// Points of the picture that are tried, in clip coordinates: a little below the middle first.
constexpr std::array heights{-0.35, -0.6, -0.85, 0.0, 0.35};
constexpr std::array sides{0.0, 0.4, -0.4, 0.75, -0.75};

/// Two digits of a value above 0: sizes that a person would have chosen.
double rounded(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return step * std::round(value / step);
}

double distance_to(const Camera& camera, const glm::dvec3& place_m) {
  return std::max(glm::distance(camera.eye_m, place_m), 1.0);
}

/// How high the picture is at the distance of a place, m.
double picture_height_m(const Camera& camera, const glm::dvec3& place_m) {
  return 2.0 * distance_to(camera, place_m) * std::tan(0.5 * camera.vertical_field_of_view_rad);
}

/// An element at the end of the list that this key's section is.
void append(Scene& scene, const char* key) {
  const scene::Parameter& row = *scene::find_parameter(key);
  scene::append_element(scene, row, {.subject = fmt::format("[[{}]]", scene::section_of(row.key))});
}

/// Lowest and highest place of a shape of size 1.
std::pair<glm::dvec3, glm::dvec3> extent_of_shape(std::size_t shape) {
  const TriangleMesh mesh = mesh_shapes::made_shape(mesh_shapes::shapes()[shape], 1.0, 1).mesh;
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec3& place_m : mesh.positions_m) {
    low = glm::min(low, place_m);
    high = glm::max(high, place_m);
  }
  return {low, high};
}

std::size_t shape_named(std::string_view name) {
  const auto& rows = mesh_shapes::shapes();
  return static_cast<std::size_t>(std::ranges::find(rows, name, &mesh_shapes::ShapeRow::name) - rows.begin());
}

scene::MeshScene& append_mesh(Scene& scene, std::string_view stem) {
  const std::string name = unused_name(scene.meshes, std::string(stem));
  append(scene, "mesh.name");
  scene.meshes.back().name = name;
  return scene.meshes.back();
}

AddedObject add_mesh_shape(Scene& scene, std::size_t shape, const NewPlace& place) {
  constexpr double share = 0.3;  // of the picture's height
  const auto [low, high] = extent_of_shape(shape);
  const glm::dvec3 sides_m = high - low;
  const double longest = std::max({sides_m.x, sides_m.y, sides_m.z});
  scene::MeshScene& mesh = append_mesh(scene, mesh_shapes::shapes()[shape].name);
  mesh.shape = shape;
  mesh.size_m = rounded(share * picture_height_m(place.camera, place.place_m) / longest);
  mesh.position_m = place.place_m - glm::dvec3(0.0, mesh.size_m * low.y, 0.0);
  return {{ObjectKind::mesh, scene.meshes.size() - 1}, fmt::format("added the mesh {}", mesh.name)};
}

constexpr double least_boat_m = 4.0, most_boat_m = 30.0;
// Of its speed: waves that it makes are seen, and it does not plane.
constexpr double froude_number = 0.33, gravity_mps2 = 9.81;
// Of the shape "ship", which keeps its course: its draught in lengths, and the thrust that keeps this speed
// by the cube of the length. Measured with hulls of 5, 16 and 40 m in calm water: within 6 % after 40 s.
constexpr double draught_lengths = 0.058, thrust_npm3 = 0.78;

AddedObject add_boat(Scene& scene, const NewPlace& place) {
  if (!scene.has_sea() || !place.water_m) {
    throw Error(ErrorKind::bad_usage, "boat: expected open water in the picture, found none",
                scene.has_sea() ? "turn the camera toward the water" : "add a sea first");
  }
  constexpr double share = 0.4;  // of the picture's height
  const double wanted_m = share * picture_height_m(place.camera, *place.water_m);
  const double length_m = rounded(std::clamp(wanted_m, least_boat_m, most_boat_m));
  const std::string name = unused_name(scene.bodies, "boat");
  scene::MeshScene& hull = append_mesh(scene, hull_name_of(name));
  hull.shape = shape_named("ship");
  hull.size_m = length_m;
  hull.material.colour = {0.25, 0.05, 0.02};
  append(scene, "body.name");
  scene::BodyScene& body = scene.bodies.back();
  body.name = name;
  body.mesh = hull.name;
  body.draught_m = rounded(draught_lengths * length_m);
  body.x_m = place.water_m->x;
  body.z_m = place.water_m->z;
  // Across the picture to the right, and a little away: its wake stays in view.
  constexpr double away_rad = 0.3;
  body.heading_rad = place.camera.yaw_rad - away_rad;
  body.speed_mps = rounded(froude_number * std::sqrt(gravity_mps2 * length_m));
  body.thrust_n = rounded(thrust_npm3 * length_m * length_m * length_m);
  const AddedObject added{{ObjectKind::body, scene.bodies.size() - 1},
                          fmt::format("added {}, {:g} m long: it sails while time runs", name, length_m)};
  if (!has_room_for_wake(scene)) return {added.object, added.news + no_room_for_wake};
  constexpr double window_lengths = 8.0, behind_lengths = 3.0;
  const int cells = scene.ocean.wakes.empty() ? 0 : scene.ocean.wakes.front().parameters.cells;
  append(scene, "ocean.wake.length_m");
  scene::WakeScene& wake = scene.ocean.wakes.back();
  if (cells > 0) wake.parameters.cells = cells;  // the same in all windows
  wake.parameters.length_m = rounded(window_lengths * length_m);
  wake.centre = scene::WakeCentre::body;
  wake.body = name;
  wake.behind_m = rounded(behind_lengths * length_m);
  wake.history_s = 10.0;
  return added;
}

AddedObject add_light(Scene& scene, const NewPlace& place) {
  const std::string name = unused_name(scene.lights, "light");
  append(scene, "light.name");
  scene::LightScene& light = scene.lights.back();
  light.name = name;
  light.kind = scene::LightKind::place;
  constexpr double share = 0.2;  // of the picture's height
  light.place_m = place.place_m + glm::dvec3(0.0, share * picture_height_m(place.camera, place.place_m), 0.0);
  return {{ObjectKind::light, scene.lights.size() - 1},
          fmt::format("added {}, which shines on meshes and clouds", name)};
}

AddedObject add_new_cloud(Scene& scene, clouds::Genus genus, const NewPlace& place) {
  // Straight ahead, where the line of sight would be at the height of its kind if it rose by 20 degrees.
  constexpr double rise = 0.36;
  const double altitude_m = clouds::preset(genus).position_m.y;
  const double way_m = std::max(altitude_m - place.camera.eye_m.y, 500.0) / rise;
  const double yaw_rad = place.camera.yaw_rad;
  const glm::dvec3 there_m(place.camera.eye_m.x + way_m * std::sin(yaw_rad), altitude_m,
                           place.camera.eye_m.z - way_m * std::cos(yaw_rad));
  const CloudPart part = add_cloud(scene, genus, there_m);
  const std::string name = unused_name(scene.clouds, std::string(clouds::range_of(genus).name));
  scene.clouds[part.cloud].name = name;
  return {{ObjectKind::cloud, part.cloud}, fmt::format("added the cloud {}; X looks at it", name)};
}

AddedObject add_layer(Scene& scene, clouds::Genus genus, const NewPlace& place) {
  append(scene, "cloud_layer.coverage");
  scene::CloudLayerScene& layer = scene.cloud_layers.back();
  layer.genus = genus;
  layer.seed = scene.cloud_layers.size();
  layer.x_m = within_range("cloud_layer.x_m", std::round(place.camera.eye_m.x));
  layer.z_m = within_range("cloud_layer.z_m", std::round(place.camera.eye_m.z));
  return {{ObjectKind::cloud_layer, scene.cloud_layers.size() - 1},
          fmt::format("added a layer of {} clouds", clouds::range_of(genus).name)};
}

AddedObject add_lake(Scene& scene, const NewPlace& place) {
  if (!scene.terrain.is_given)
    throw Error(ErrorKind::bad_usage, "lake: expected terrain with a basin, found none", "add terrain first");
  const std::string name = unused_name(scene.lakes, "lake");
  append(scene, "lake.name");
  scene::LakeScene& lake = scene.lakes.back();
  lake.name = name;
  lake.x_m = place.place_m.x;
  lake.z_m = place.place_m.z;
  return {{ObjectKind::lake, scene.lakes.size() - 1},
          fmt::format("added {}, as full as its basin holds", name)};
}

AddedObject add_section(Scene& scene, ObjectKind kind, bool& is_given, std::string_view word) {
  const bool is_there = kind == ObjectKind::sea ? scene.has_sea() : is_given;
  if (is_there) {
    throw Error(ErrorKind::bad_usage, fmt::format("the scene has {} already", word), "edit what it has");
  }
  is_given = true;
  return {{kind, 0}, fmt::format("added {}", word)};
}

}  // namespace

NewPlace new_place(LiveSea& sea, const Screen& screen) {
  NewPlace place{.camera = screen.camera};
  std::optional<glm::dvec3> surface_m;
  for (const double side : sides) {
    for (const double height : heights) {
      if (surface_m && (place.water_m || !sea.scene().has_sea())) break;
      const std::optional<SurfacePlace> seen = seen_surface(sea, screen, {side, height});
      if (!seen || glm::distance(seen->place_m, screen.camera.eye_m) > farthest_new_m) continue;
      if (!surface_m) surface_m = seen->place_m;
      if (!place.water_m && seen->is_water) place.water_m = seen->place_m;
    }
  }
  place.place_m = surface_m.value_or(screen.camera.eye_m + ahead_m * basis(screen.camera).forward);
  return place;
}

glm::dvec3 way_beside(const LiveSea& sea, const SceneObject& object, const Screen& screen) {
  constexpr double share = 0.2, diagonals = 0.8;
  double way_m = share * ahead_m;
  std::optional<std::size_t> mesh;
  if (object.kind == ObjectKind::mesh) mesh = object.index;
  if (object.kind == ObjectKind::body) mesh = hull_of_body(sea.scene(), object.index);
  if (mesh && *mesh < sea.meshes().size()) way_m = diagonals * sea.meshes()[*mesh].surface().diagonal_m();
  if (object.kind == ObjectKind::cloud_layer) way_m = sea.scene().cloud_layers[object.index].extent_m;
  const double yaw_rad = screen.camera.yaw_rad;
  return way_m * glm::dvec3(std::cos(yaw_rad), 0.0, std::sin(yaw_rad));
}

AddedObject add_object(Scene& scene, const NewObject& object, const NewPlace& place) {
  // Beside what stands alone a sea has to be named.
  const bool had_sea = scene.has_sea();
  using enum NewObject::Kind;
  AddedObject added;
  switch (object.kind) {
    case boat:
      added = add_boat(scene, place);
      break;
    case mesh:
      added = add_mesh_shape(scene, object.shape, place);
      break;
    case light:
      added = add_light(scene, place);
      break;
    case cloud:
      added = add_new_cloud(scene, object.genus, place);
      break;
    case cloud_layer:
      added = add_layer(scene, object.genus, place);
      break;
    case sea:
      return add_section(scene, ObjectKind::sea, scene.ocean.is_given, "a sea");
    case terrain:
      added = add_section(scene, ObjectKind::terrain, scene.terrain.is_given, "terrain");
      break;
    case lake:
      return add_lake(scene, place);
    case bookmark:
      added.object = {ObjectKind::bookmark, scene.bookmarks.size()};
      added.news = set_bookmark(scene, place.camera, scene.bookmarks.size() + 1);
      break;
  }
  scene.ocean.is_given = scene.ocean.is_given || had_sea;
  return added;
}

}  // namespace offing::present
