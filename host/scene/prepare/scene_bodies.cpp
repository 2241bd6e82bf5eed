#include "host/scene/prepare/scene_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/bodies/hull.h"
#include "host/bodies/path_drive.h"
#include "host/bodies/pressed_hull.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/model/moving_number.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/body_hydrodynamics.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {

namespace {

using bodies::FloatingBody;

constexpr double water_kgpm3 = bodies::BodyWaterParameters{}.density_kgpm3;
constexpr double least_run_up_s = 10.0;
// Of a path's speed before its time 0: short against any manoeuvre.
constexpr double speed_step_s = 0.01;

/// Drives of a body at any time, and where it is in its run-up. Its own copy of what it needs: the scene may
/// go.
class BodyHeading {
 public:
  BodyHeading(const Scene& scene, std::size_t index)
      : body_(scene.bodies[index]),
        x_m_(scene, {"body.x_m", {index, 0}}, body_.x_m),
        z_m_(scene, {"body.z_m", {index, 0}}, body_.z_m),
        heading_rad_(scene, {"body.heading_deg", {index, 0}}, body_.heading_rad),
        thrust_n_(scene, {"body.thrust_n", {index, 0}}, body_.thrust_n),
        rudder_rad_(scene, {"body.rudder_deg", {index, 0}}, body_.rudder_rad) {}

  /// Before time 0 it goes straight ahead, as fast as it does then.
  bodies::PathPlace place_at(double time_s) const {
    if (time_s >= 0.0) return on_path(time_s);
    const bodies::PathPlace start = on_path(0.0), next = on_path(speed_step_s);
    const double steps = time_s / speed_step_s;
    return {start.x_m + steps * (next.x_m - start.x_m), start.z_m + steps * (next.z_m - start.z_m),
            start.heading_rad};
  }

  BodyDrive drive_at(double time_s, double start_s) const {
    const bool is_led = body_.motion == BodyMotion::path;
    if (is_led) return bodies::drive_along([&](double at_s) { return place_at(at_s); }, time_s);
    // A sub-step belongs to the run-up if its middle does.
    if (time_s + 0.5 / bodies::FloatingBodies::steps_per_s < start_s) {
      return bodies::drive_along([&](double at_s) { return place_at(std::min(at_s - start_s, 0.0)); },
                                 time_s);
    }
    BodyDrive drive{};
    drive.thrust_n = static_cast<float>(thrust_n_.at(time_s));
    drive.rudder_rad = static_cast<float>(rudder_rad_.at(time_s));
    return drive;
  }

 private:
  bodies::PathPlace on_path(double time_s) const {
    const double heading_rad = heading_rad_.at(time_s), way_m = body_.speed_mps * time_s;
    return {x_m_.at(time_s) + way_m * std::cos(heading_rad), z_m_.at(time_s) + way_m * std::sin(heading_rad),
            heading_rad};
  }

  BodyScene body_;
  MovingNumber x_m_, z_m_, heading_rad_, thrust_n_, rudder_rad_;
};

std::vector<std::string> names_of_bodies(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodyScene& body : scene.bodies) {
    if (!body.name.empty()) names.push_back(body.name);
  }
  return names;
}

void require_other_mesh(const Scene& scene, const std::vector<world::BodySettings>& known, std::size_t mesh) {
  if (std::ranges::find(known, mesh, &world::BodySettings::mesh) == known.end()) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a mesh that no other body moves, got \"{}\"",
                          place_of_name(scene, {"body.mesh", {known.size(), 0}}), scene.meshes[mesh].name),
              "give each body a [[mesh]] of its own");
}

/// Puts the meshes that are carried aboard the bodies that carry them.
void board(const Scene& scene, std::vector<world::BodySettings>& bodies) {
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    const std::string& name = scene.meshes[mesh].aboard;
    if (name.empty()) continue;
    const auto body = std::ranges::find(scene.bodies, name, &BodyScene::name);
    const bool is_body = std::ranges::find(bodies, mesh, &world::BodySettings::mesh) != bodies.end();
    if (body == scene.bodies.end() || is_body) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected the name of a [[body]] that carries it, got \"{}\"",
                              place_of_name(scene, {"mesh.aboard", {mesh, 0}}), name),
                  is_body ? "remove aboard: a mesh with a [[body]] of its own is not carried"
                          : hint_of_names(name, names_of_bodies(scene), "give the [[body]] this name"));
    }
    bodies[static_cast<std::size_t>(body - scene.bodies.begin())].aboard.push_back(mesh);
  }
}

TriangleMesh in_hull_axes(const TriangleMesh& mesh, const highlights::RigidMotion& motion) {
  TriangleMesh moved;
  moved.faces = mesh.faces;
  for (const glm::dvec3& place_m : mesh.positions_m) {
    moved.positions_m.push_back(motion.rotation * place_m + motion.translation_m);
  }
  return moved;
}

FloatingBody loaded(const BodyScene& scene, const std::string& name, TriangleMesh hull) {
  FloatingBody body;
  if (scene.draught_m) {
    const double level_m = bodies::extent_of(hull).low_m.y + *scene.draught_m;
    body = bodies::load_to_level(name, std::move(hull), level_m, water_kgpm3);
  } else {
    const double mass_kg = scene.mass_kg.value_or(scene.density_kgpm3 * bodies::enclosed_by(hull).volume_m3);
    body = bodies::load_to_mass(name, std::move(hull), mass_kg, water_kgpm3);
  }
  body.mass_centre_m = scene.mass_centre_m.value_or(body.mass_centre_m);
  body.drive.propeller_diameter_m = scene.propeller_m.value_or(body.drive.propeller_diameter_m);
  body.drag.windage = scene.windage;
  body.drive.rudder_area_m2 = scene.rudder_m2.value_or(body.drive.rudder_area_m2);
  return body;
}

/// Lines that are just taut are so where the body floats at this pose.
std::vector<bodies::MooringLine> moorings_of(const BodyScene& scene, const FloatingBody& body,
                                             const bodies::BodyPose& at_start) {
  std::vector<bodies::MooringLine> lines;
  for (const MooringScene& each : scene.moorings) {
    const glm::dvec3 place_m = bodies::FloatingBodies::world_point(body, at_start, each.hull_m);
    lines.push_back({.hull_m = each.hull_m,
                     .anchor_m = each.anchor_m,
                     .length_m = each.length_m.value_or(glm::distance(place_m, each.anchor_m)),
                     .stiffness_npm = each.stiffness_npm});
  }
  return lines;
}

world::BodySettings settings_of(const Scene& scene, std::size_t index, std::size_t mesh,
                                const world::MeshParameters& drawn) {
  const BodyScene& body = scene.bodies[index];
  const std::string name = body.name.empty() ? fmt::format("body {}", index + 1) : body.name;
  // A mesh of a body stands still within it.
  const highlights::RigidMotion in_hull = drawn.motion(0.0);
  const TriangleMesh whole = in_hull_axes(*drawn.mesh, in_hull);
  bodies::require_hull(whole, name.c_str());
  world::BodySettings settings;
  settings.mesh = mesh;
  settings.mesh_in_hull = in_hull;
  settings.map = std::make_shared<const bodies::HullMap>(bodies::map_of_hull(whole));
  settings.body = loaded(
      body, name, bodies::pressed_hull(whole, *settings.map, static_cast<std::size_t>(body.hull_faces)));
  settings.body.hydrodynamics = read_body_hydrodynamics(scene, index, settings.body);
  const auto course = std::make_shared<const BodyHeading>(scene, index);
  const auto rest_at = [&](double time_s) {
    const bodies::PathPlace place = course->place_at(time_s);
    return bodies::at_rest(settings.body, water_kgpm3, place.x_m, place.z_m, place.heading_rad);
  };
  settings.body.start = rest_at(-run_up_s(scene));
  if (!body.moorings.empty()) settings.body.moorings = moorings_of(body, settings.body, rest_at(0.0));
  bodies::require_valid(settings.body);
  settings.drive = [course](double time_s, double start_s) { return course->drive_at(time_s, start_s); };
  return settings;
}

std::optional<KeyframeTrack> track_of(const Scene& scene, const ValueKey& key) {
  const auto track = scene.tracks.find(key);
  return track == scene.tracks.end() ? std::nullopt : std::optional(track->second);
}

/// Whether a value of an element, keyframes included, is that of an element of another scene.
bool is_same_row(const Parameter& row, const Scene& before, std::size_t index_before, const Scene& after,
                 std::size_t index_after) {
  const ElementIndex element_before{index_before, 0}, element_after{index_after, 0};
  return is_same_value(row, struct_at(&before, *row.section, element_before),
                       struct_at(&after, *row.section, element_after)) &&
         track_of(before, {row.key, element_before}) == track_of(after, {row.key, element_after});
}

/// Whether two meshes have the same form and stand at the same place.
bool is_same_mesh(const Scene& before, std::size_t mesh_before, const Scene& after, std::size_t mesh_after) {
  return std::ranges::all_of(parameter_table(), [&](const Parameter& row) {
    if (row.group != ParameterGroup::mesh || !share_a_bit(row.affects, Affects::meshes)) return true;
    return is_same_row(row, before, mesh_before, after, mesh_after);
  });
}

/// Whether a body can go on as another one from where that one is. Start, hull and load must be the same: its
/// place is that of the centre of mass in the axes of the hull, and whoever edits the start wants to see it.
/// What only changes the forces on it acts from then on.
bool goes_on_as(const Scene& before, std::size_t body_before, const Scene& after, std::size_t body_after) {
  constexpr std::array<std::string_view, 9> names_and_forces{
      "body.name",       "body.mesh",          "body.thrust_n",
      "body.rudder_deg", "body.propeller_m",   "body.rudder_m2",
      "body.windage",    "body.hydrodynamics", "body.hydrodynamics_length_m"};
  const bool is_same = std::ranges::all_of(parameter_table(), [&](const Parameter& row) {
    if (row.group != ParameterGroup::body ||
        std::ranges::find(names_and_forces, row.key) != names_and_forces.end())
      return true;
    return is_same_row(row, before, body_before, after, body_after);
  });
  return is_same &&
         is_same_mesh(before, mesh_of_body(before, body_before), after, mesh_of_body(after, body_after));
}

/// For each body of a scene which one of the scene before it is; none: it begins anew.
std::vector<std::optional<std::size_t>> bodies_before(const Scene& before, const Scene& after) {
  std::vector<std::optional<std::size_t>> found(after.bodies.size());
  std::vector<bool> is_taken(before.bodies.size(), false);
  for (std::size_t body = 0; body < found.size(); ++body) {
    for (std::size_t each = 0; each < is_taken.size() && !found[body]; ++each) {
      if (is_taken[each] || !goes_on_as(before, each, after, body)) continue;
      found[body] = each;
      is_taken[each] = true;
    }
  }
  return found;
}

/// Whether bodies of the same numbers move alike. Meshes that move with no body do not count, nor those
/// aboard, nor the numbers of hulls.
bool are_same_bodies(const Scene& before, const Scene& after) {
  if (differ_in(Affects::bodies, before, after)) return false;
  for (std::size_t body = 0; body < after.bodies.size(); ++body) {
    if (!is_same_mesh(before, mesh_of_body(before, body), after, mesh_of_body(after, body))) return false;
  }
  return true;
}

}  // namespace

std::size_t mesh_of_body(const Scene& scene, std::size_t body) {
  const std::string& name = scene.bodies[body].mesh;
  const auto mesh =
      name.empty() ? scene.meshes.begin() : std::ranges::find(scene.meshes, name, &MeshScene::name);
  if (mesh != scene.meshes.end()) return static_cast<std::size_t>(mesh - scene.meshes.begin());
  std::vector<std::string> names;
  for (const MeshScene& each : scene.meshes) {
    if (!each.name.empty()) names.push_back(each.name);
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected the name of a [[mesh]], got \"{}\"",
                          place_of_name(scene, {"body.mesh", {body, 0}}), name),
              hint_of_names(name, names,
                            scene.meshes.empty() ? "add a [[mesh]] of this name"
                                                 : "no [[mesh]] has a name: give one this name"));
}

double run_up_s(const Scene& scene) {
  double longest_s = least_run_up_s;
  for (const WakeScene& wake : scene.ocean.wakes) longest_s = std::max(longest_s, wake.history_s);
  return longest_s;
}

std::vector<world::BodySettings> prepare_bodies(const Scene& scene,
                                                const std::vector<world::MeshParameters>& meshes) {
  std::vector<world::BodySettings> prepared;
  if (!scene.bodies.empty() && !scene.has_sea()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a sea for the body, found none",
                            place_of_name(scene, {"body.mesh", {0, 0}})),
                "add an [ocean] section to the scene");
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::size_t mesh = mesh_of_body(scene, i);
    require_other_mesh(scene, prepared, mesh);
    try {
      prepared.push_back(settings_of(scene, i, mesh, meshes.at(mesh)));
    } catch (const Error& error) {
      throw Error(error.kind(),
                  fmt::format("{}: {}", place_of_name(scene, {"body.mesh", {i, 0}}), error.what()),
                  error.hint());
    }
  }
  board(scene, prepared);
  return prepared;
}

std::size_t followed_body(const Scene& scene, std::size_t wake) {
  const std::string& name = scene.ocean.wakes[wake].body;
  const auto body =
      name.empty() ? scene.bodies.begin() : std::ranges::find(scene.bodies, name, &BodyScene::name);
  if (body != scene.bodies.end()) return static_cast<std::size_t>(body - scene.bodies.begin());
  const char* key = name.empty() ? "ocean.wake.centre" : "ocean.wake.body";
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected the name of a [[body]], got \"{}\"", place_of_name(scene, {key, {wake, 0}}),
                  name),
      hint_of_names(name, names_of_bodies(scene), "add a [[body]] of that name, or choose another centre"));
}

void edit_bodies(world::World& world, const Scene& before, const Scene& after) {
  const bool is_same = before.has_sea() == after.has_sea() && run_up_s(before) == run_up_s(after) &&
                       are_same_bodies(before, after);
  if (!is_same) {
    world.set_bodies(prepare_bodies(after, world.parameters().meshes), run_up_s(after),
                     bodies_before(before, after));
    return;
  }
  const std::vector<world::BodySettings>& known = world.parameters().bodies;
  std::vector<world::BodySettings> bodies = known;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].mesh = mesh_of_body(after, i);
    bodies[i].aboard.clear();
  }
  board(after, bodies);
  const auto has_same_meshes = [](const world::BodySettings& a, const world::BodySettings& b) {
    return a.mesh == b.mesh && a.aboard == b.aboard;
  };
  if (!std::ranges::equal(bodies, known, has_same_meshes)) world.renumber_body_meshes(bodies);
}

}  // namespace offing::scene
