#include "present/editing/objects/scene_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/bodies/floating_bodies.h"
#include "host/bodies/floating_body.h"
#include "host/clouds/shape/genera.h"
#include "host/scene/model/moving_number.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/cloud_edits.h"
#include "present/editing/objects/pushed_value.h"

namespace offing::present {
namespace {

using scene::ElementIndex;
using scene::Parameter;
using scene::Scene;

/// What is the same for all objects of a kind.
struct KindRow {
  ObjectKind kind;
  std::string_view word;  ///< for labels of objects without a name
  /// A key of the section whose elements they are; empty: there is one at most.
  std::string_view key;
  bool has_name;
};
constexpr std::array kind_rows{KindRow{ObjectKind::camera, "camera", "", false},
                               KindRow{ObjectKind::bookmark, "bookmark", "bookmark.name", true},
                               KindRow{ObjectKind::sky, "sun and sky", "", false},
                               KindRow{ObjectKind::sea, "sea", "", false},
                               KindRow{ObjectKind::wake, "wake", "ocean.wake.length_m", false},
                               KindRow{ObjectKind::terrain, "terrain", "", false},
                               KindRow{ObjectKind::lake, "lake", "lake.name", true},
                               KindRow{ObjectKind::cloud_layer, "cloud layer", "cloud_layer.coverage", false},
                               KindRow{ObjectKind::cloud, "cloud", "cloud.name", true},
                               KindRow{ObjectKind::mesh, "mesh", "mesh.name", true},
                               KindRow{ObjectKind::body, "body", "body.name", true},
                               KindRow{ObjectKind::light, "light", "light.name", true}};

const KindRow& row_of(ObjectKind kind) {
  return *std::ranges::find(kind_rows, kind, &KindRow::kind);
}

const scene::Section& section_of_kind(ObjectKind kind) {
  return *scene::find_parameter(row_of(kind).key)->section;
}

std::string name_of_object(const Scene& scene, const SceneObject& object) {
  const Parameter* row = name_row(object.kind);
  if (row == nullptr) return {};
  return std::get<scene::ValueAt<std::string>>(row->storage)
      .in(scene::struct_at(&scene, *row->section, {object.index, 0}));
}

/// Begins an element like another one, keyframes included; returns where.
template <class List>
std::size_t append_copy(Scene& scene, ObjectKind kind, List& list, std::size_t from) {
  const Parameter& row = *scene::find_parameter(row_of(kind).key);
  scene::append_element(scene, row, {.subject = fmt::format("[[{}]]", scene::section_of(row.key))});
  const std::size_t to = list.size() - 1;
  list[to] = list[from];
  std::vector<std::pair<scene::ValueKey, KeyframeTrack>> copies;
  for (const auto& [key, track] : scene.tracks) {
    const scene::Section& section = *scene::find_parameter(key.key)->section;
    const bool is_of_list = &section == row.section || section.repeated_parent() == row.section;
    if (!is_of_list || key.element.outer != from) continue;
    copies.emplace_back(key, track);
    copies.back().first.element.outer = to;
  }
  scene.tracks.insert(copies.begin(), copies.end());
  return to;
}

void push_place(Scene& scene, std::string_view section, std::size_t index, const glm::dvec3& way_m) {
  for (const auto& [name, way] : {std::pair("x_m", way_m.x), {"y_m", way_m.y}, {"z_m", way_m.z}}) {
    const Parameter* row = scene::find_parameter(fmt::format("{}.{}", section, name));
    if (row != nullptr && way != 0.0) push_value(scene, row->key, {index, 0}, way);
  }
}

std::vector<std::size_t> meshes_aboard(const Scene& scene, std::size_t body) {
  std::vector<std::size_t> meshes;
  const std::string& name = scene.bodies[body].name;
  for (std::size_t i = 0; !name.empty() && i < scene.meshes.size(); ++i) {
    if (scene.meshes[i].aboard == name) meshes.push_back(i);
  }
  return meshes;
}

std::size_t copy_mesh(Scene& scene, std::size_t mesh) {
  const std::string& name = scene.meshes[mesh].name;
  const std::string copied_name = unused_name(scene.meshes, name.empty() ? "mesh" : name);
  const std::size_t copy = append_copy(scene, ObjectKind::mesh, scene.meshes, mesh);
  scene.meshes[copy].name = copied_name;
  return copy;
}

/// Of a body, for its copy, as far as there is room.
void copy_wakes(Scene& scene, std::size_t body, const std::string& copied_name) {
  const std::size_t count = scene.ocean.wakes.size();
  for (std::size_t i = 0; i < count && has_room_for_wake(scene); ++i) {
    if (body_of_part(scene, {ObjectKind::wake, i}) != body) continue;
    const std::size_t copy = append_copy(scene, ObjectKind::wake, scene.ocean.wakes, i);
    scene.ocean.wakes[copy].body = copied_name;
  }
}

/// With its hull and what is aboard; returns the hull's copy and the body's.
std::pair<std::size_t, std::size_t> copy_body(Scene& scene, std::size_t body, std::size_t hull,
                                              const glm::dvec3& way_m) {
  const std::vector<std::size_t> aboard = meshes_aboard(scene, body);
  const std::string name = scene.bodies[body].name;
  const std::string copied_name = unused_name(scene.bodies, name.empty() ? "body" : name);
  const std::size_t mesh = copy_mesh(scene, hull);
  const std::size_t copy = append_copy(scene, ObjectKind::body, scene.bodies, body);
  scene.bodies[copy].name = copied_name;
  scene.bodies[copy].mesh = scene.meshes[mesh].name;
  push_place(scene, "body", copy, way_m);
  for (const std::size_t each : aboard) scene.meshes[copy_mesh(scene, each)].aboard = copied_name;
  copy_wakes(scene, body, copied_name);
  return {mesh, copy};
}

void remove_element_of(Scene& scene, ObjectKind kind, std::size_t index) {
  scene::remove_element(scene, section_of_kind(kind), {index, 0});
}

void remove_wakes_of(Scene& scene, std::size_t body) {
  for (std::size_t i = scene.ocean.wakes.size(); i-- > 0;) {
    if (body_of_part(scene, {ObjectKind::wake, i}) == body) remove_element_of(scene, ObjectKind::wake, i);
  }
}

/// A body that floats upright at its start.
struct FloatingStart {
  bodies::FloatingBody body;
  bodies::BodyPose pose;
};
FloatingStart start_of(const Scene& scene, std::size_t index) {
  const scene::BodyScene& body = scene.bodies[index];
  const auto at_start = [&](std::string_view key, double constant) {
    return scene::MovingNumber(scene, {key, {index, 0}}, constant).at(0.0);
  };
  FloatingStart start{scene::prepare_bodies(scene, scene::prepare_meshes(scene))[index].body, {}};
  start.pose =
      bodies::at_rest(start.body, bodies::BodyWaterParameters{}.density_kgpm3, at_start("body.x_m", body.x_m),
                      at_start("body.z_m", body.z_m), at_start("body.heading_deg", body.heading_rad));
  start.pose.mass_centre_m.y += scene.sea_level_m();
  return start;
}

/// From a body's axes to the world, keyframes included. Its turn is that of a mesh (camera.h), whose yaw
/// grows from north toward east as a heading does from east toward south.
void place_in_world(Scene& scene, std::size_t mesh, const FloatingStart& start) {
  scene::MeshScene& placed = scene.meshes[mesh];
  placed.aboard.clear();
  const ElementIndex element{mesh, 0};
  const scene::ValueKey x_key{"mesh.x_m", element}, z_key{"mesh.z_m", element};
  const scene::MovingNumber x_m(scene, x_key, placed.position_m.x), z_m(scene, z_key, placed.position_m.z);
  const auto in_world = [&](double x, double z) {
    return bodies::FloatingBodies::world_point(start.body, start.pose, {x, placed.position_m.y, z});
  };
  // Both move with either.
  std::set<double> times_s;
  Interpolation interpolation = Interpolation::smooth;
  for (const scene::ValueKey& key : {x_key, z_key}) {
    const auto track = scene.tracks.find(key);
    if (track == scene.tracks.end()) continue;
    interpolation = track->second.interpolation;
    for (const Keyframe& at : track->second.keys) times_s.insert(at.time_s);
  }
  KeyframeTrack east{.keys = {}, .interpolation = interpolation}, south = east;
  for (const double time_s : times_s) {
    const glm::dvec3 there_m = in_world(x_m.at(time_s), z_m.at(time_s));
    east.keys.push_back({time_s, within_range(x_key.key, there_m.x)});
    south.keys.push_back({time_s, within_range(z_key.key, there_m.z)});
  }
  const glm::dvec3 there_m = in_world(placed.position_m.x, placed.position_m.z);
  push_value(scene, "mesh.y_m", element, there_m.y - placed.position_m.y);
  placed.position_m.x = within_range(x_key.key, there_m.x);
  placed.position_m.z = within_range(z_key.key, there_m.z);
  if (!times_s.empty()) {
    scene.tracks[x_key] = std::move(east);
    scene.tracks[z_key] = std::move(south);
  }
  turn_value(scene, "mesh.yaw_deg", element, bodies::heading_of(start.pose));
}

/// With its hull and what is aboard.
void remove_body(Scene& scene, std::size_t body) {
  std::vector<std::size_t> gone = meshes_aboard(scene, body);
  if (const std::optional<std::size_t> hull = hull_of_body(scene, body)) gone.push_back(*hull);
  remove_wakes_of(scene, body);
  remove_element_of(scene, ObjectKind::body, body);
  std::ranges::sort(gone, std::greater());
  for (const std::size_t mesh : gone) remove_element_of(scene, ObjectKind::mesh, mesh);
}

/// Of a section and those below it.
void forget_values(Scene& scene, std::string_view section) {
  const auto is_below = [&](const auto& entry) {
    return entry.first.key.starts_with(section) && entry.first.key.substr(section.size()).starts_with('.');
  };
  std::erase_if(scene.tracks, is_below);
  std::erase_if(scene.set_at, is_below);
}

void remove_sea(Scene& scene) {
  if (!scene.bodies.empty()) {
    throw Error(ErrorKind::bad_usage, "the sea carries bodies: expected none of them", "delete these first");
  }
  scene.ocean = {};
  forget_values(scene, "ocean");
}

/// All that refer to a name.
std::vector<std::string*> references_to(Scene& scene, ObjectKind kind, const std::string& name) {
  std::vector<std::string*> found;
  const auto look = [&](std::string& text) {
    if (text == name) found.push_back(&text);
  };
  if (kind == ObjectKind::mesh) {
    for (scene::BodyScene& body : scene.bodies) look(body.mesh);
  }
  if (kind == ObjectKind::body) {
    for (scene::MeshScene& mesh : scene.meshes) look(mesh.aboard);
    for (scene::WakeScene& wake : scene.ocean.wakes) look(wake.body);
  }
  if (kind == ObjectKind::light) {
    for (scene::MeshScene& mesh : scene.meshes) {
      for (scene::HighlightScene& highlight : mesh.highlights) look(highlight.light);
    }
  }
  return found;
}

bool has_another(const Scene& scene, const SceneObject& object, const std::string& name) {
  for (std::size_t i = 0; i < count_of(scene, object.kind); ++i) {
    if (i != object.index && name_of_object(scene, {object.kind, i}) == name) return true;
  }
  return false;
}

/// Names refer to the first that has them.
bool is_first_of_its_name(const Scene& scene, const SceneObject& object, const std::string& name) {
  for (std::size_t i = 0; i < object.index; ++i) {
    if (name_of_object(scene, {object.kind, i}) == name) return false;
  }
  return true;
}

}  // namespace

std::string hull_name_of(const std::string& body) {
  return body + " hull";
}

std::vector<SceneObject> objects_of(const Scene& scene) {
  std::vector<SceneObject> objects;
  std::vector<bool> is_listed(scene.bodies.size(), false);
  const auto list_body = [&](std::size_t body) {
    if (is_listed[body]) return;
    is_listed[body] = true;
    objects.push_back({ObjectKind::body, body});
    const std::vector<SceneObject> parts = parts_of_body(scene, body);
    objects.insert(objects.end(), parts.begin(), parts.end());
  };
  for (const KindRow& row : kind_rows) {
    const std::size_t count = count_of(scene, row.kind);
    for (std::size_t i = 0; i < count; ++i) {
      const SceneObject object{row.kind, i};
      const std::optional<std::size_t> body = body_of_part(scene, object);
      // Where its first mesh is in the scene's order.
      if (row.kind == ObjectKind::mesh && body) list_body(*body);
      if (row.kind == ObjectKind::body) list_body(i);
      if (row.kind != ObjectKind::body && !body) objects.push_back(object);
    }
  }
  return objects;
}

std::optional<std::size_t> body_of_part(const Scene& scene, const SceneObject& object) {
  const auto named = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto body = std::ranges::find(scene.bodies, name, &scene::BodyScene::name);
    if (name.empty() || body == scene.bodies.end()) return {};
    return static_cast<std::size_t>(body - scene.bodies.begin());
  };
  if (object.kind == ObjectKind::mesh) {
    const std::optional<std::size_t> body = body_of_mesh(scene, object.index);
    return body ? body : named(scene.meshes[object.index].aboard);
  }
  if (object.kind != ObjectKind::wake) return {};
  const scene::WakeScene& wake = scene.ocean.wakes[object.index];
  if (wake.centre != scene::WakeCentre::body) return {};
  if (wake.body.empty() && !scene.bodies.empty()) return 0;  // the first
  return named(wake.body);
}

std::vector<SceneObject> parts_of_body(const Scene& scene, std::size_t body) {
  std::vector<SceneObject> parts;
  for (const ObjectKind kind : {ObjectKind::mesh, ObjectKind::wake}) {
    for (std::size_t i = 0; i < count_of(scene, kind); ++i) {
      const SceneObject part{kind, i};
      if (body_of_part(scene, part) == body) parts.push_back(part);
    }
  }
  return parts;
}

bool has_room_for_wake(const Scene& scene) {
  return scene.ocean.wakes.size() < section_of_kind(ObjectKind::wake).max_count;
}

std::size_t count_of(const Scene& scene, ObjectKind kind) {
  switch (kind) {
    case ObjectKind::camera:
    case ObjectKind::sky:
      return 1;
    case ObjectKind::sea:
      return scene.has_sea() ? 1 : 0;
    case ObjectKind::terrain:
      return scene.terrain.is_given ? 1 : 0;
    case ObjectKind::lake:
      return scene.terrain.is_given ? scene.lakes.size() : 0;
    case ObjectKind::wake:
      return scene.has_sea() ? scene.ocean.wakes.size() : 0;
    default:
      return scene::elements_of(scene, section_of_kind(kind)).size();
  }
}

bool has_object(const Scene& scene, const SceneObject& object) {
  return object.index < count_of(scene, object.kind);
}

const Parameter* name_row(ObjectKind kind) {
  const KindRow& row = row_of(kind);
  return row.has_name ? scene::find_parameter(row.key) : nullptr;
}

std::string label_of(const Scene& scene, const SceneObject& object) {
  const KindRow& row = row_of(object.kind);
  if (std::string name = name_of_object(scene, object); !name.empty()) return name;
  if (object.kind == ObjectKind::wake) {
    const scene::WakeScene& wake = scene.ocean.wakes[object.index];
    if (wake.centre == scene::WakeCentre::body && !wake.body.empty())
      return fmt::format("wake of {}", wake.body);
  }
  if (object.kind == ObjectKind::cloud_layer) {
    return fmt::format("{} layer", clouds::range_of(scene.cloud_layers[object.index].genus).name);
  }
  return row.key.empty() ? std::string(row.word) : fmt::format("{} {}", row.word, object.index + 1);
}

std::vector<scene::ParameterGroup> groups_of(ObjectKind kind) {
  using enum scene::ParameterGroup;
  switch (kind) {
    case ObjectKind::camera:
      return {camera};
    case ObjectKind::bookmark:
      return {bookmark};
    case ObjectKind::sky:
      return {sun, sky};
    case ObjectKind::sea:
      return {wind, sea, foam};
    case ObjectKind::wake:
      return {wake};
    case ObjectKind::terrain:
      return {height_map, terrain};
    case ObjectKind::lake:
      return {lake};
    case ObjectKind::cloud_layer:
      return {cloud_layer};
    case ObjectKind::cloud:
      return {cloud};
    case ObjectKind::mesh:
      return {mesh};
    case ObjectKind::body:
      return {body};
    case ObjectKind::light:
      return {light};
  }
  return {};
}

std::optional<std::size_t> hull_of_body(const Scene& scene, std::size_t body) {
  const std::string& name = scene.bodies[body].mesh;
  const auto mesh =
      name.empty() ? scene.meshes.begin() : std::ranges::find(scene.meshes, name, &scene::MeshScene::name);
  if (mesh == scene.meshes.end()) return {};
  return static_cast<std::size_t>(mesh - scene.meshes.begin());
}

std::optional<std::size_t> body_of_mesh(const Scene& scene, std::size_t mesh) {
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    if (hull_of_body(scene, body) == mesh) return body;
  }
  return {};
}

bool can_be_removed(const Scene& scene, const SceneObject& object) {
  switch (object.kind) {
    case ObjectKind::camera:
    case ObjectKind::sky:
      return false;
    case ObjectKind::sea:
      // What has nothing else is a sea.
      return scene.terrain.is_given || !scene.meshes.empty() || scene.has_clouds();
    default:
      return true;
  }
}

bool can_be_duplicated(const SceneObject& object) {
  return !row_of(object.kind).key.empty() && object.kind != ObjectKind::bookmark &&
         object.kind != ObjectKind::lake;
}

void remove_object(Scene& scene, const SceneObject& object) {
  if (!can_be_removed(scene, object)) {
    throw Error(ErrorKind::bad_usage, fmt::format("{}: cannot be deleted", label_of(scene, object)),
                object.kind == ObjectKind::sea ? "add terrain, a mesh or a cloud, which can be without a sea"
                                               : "each scene has one");
  }
  // Else a sea would come with the last thing that can be without.
  const bool had_sea = scene.has_sea();
  switch (object.kind) {
    case ObjectKind::sea:
      remove_sea(scene);
      return;
    case ObjectKind::terrain:
      scene.terrain = {};
      forget_values(scene, "terrain");
      scene.lakes.clear();
      forget_values(scene, "lake");
      break;
    case ObjectKind::mesh:
      if (const std::optional<std::size_t> body = body_of_mesh(scene, object.index)) {
        remove_body(scene, *body);
      } else {
        remove_element_of(scene, ObjectKind::mesh, object.index);
      }
      break;
    case ObjectKind::body:
      remove_body(scene, object.index);
      break;
    default:
      remove_element_of(scene, object.kind, object.index);
  }
  scene.ocean.is_given = scene.ocean.is_given || had_sea;
}

void stop_floating(Scene& scene, std::size_t index) {
  const FloatingStart start = start_of(scene, index);
  std::vector<std::size_t> meshes = meshes_aboard(scene, index);
  meshes.push_back(scene::mesh_of_body(scene, index));
  for (const std::size_t mesh : meshes) place_in_world(scene, mesh, start);
  remove_wakes_of(scene, index);
  remove_element_of(scene, ObjectKind::body, index);
}

SceneObject duplicate_object(Scene& scene, const SceneObject& object, const glm::dvec3& way_m) {
  if (!can_be_duplicated(object)) {
    throw Error(ErrorKind::bad_usage, fmt::format("{}: cannot be copied", label_of(scene, object)),
                "select a mesh, a body, a cloud, a wake or a light");
  }
  Scene changed = scene;  // where there is no room for all nothing has changed
  SceneObject copy{object.kind, 0};
  const auto hull =
      object.kind == ObjectKind::body ? hull_of_body(scene, object.index) : std::optional(object.index);
  const auto body = object.kind == ObjectKind::mesh   ? body_of_mesh(scene, object.index)
                    : object.kind == ObjectKind::body ? std::optional(object.index)
                                                      : std::nullopt;
  if (!hull) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: has no hull to copy", label_of(scene, object)),
                "give it a mesh that the scene has");
  }
  switch (object.kind) {
    case ObjectKind::mesh:
    case ObjectKind::body:
      if (body) {
        const auto [mesh_copy, body_copy] = copy_body(changed, *body, *hull, way_m);
        copy.index = object.kind == ObjectKind::mesh ? mesh_copy : body_copy;
      } else {
        copy.index = copy_mesh(changed, object.index);
        push_place(changed, "mesh", copy.index, way_m);
      }
      break;
    case ObjectKind::light: {
      const std::string name = changed.lights[object.index].name;
      const std::string copied_name = unused_name(changed.lights, name);
      copy.index = append_copy(changed, object.kind, changed.lights, object.index);
      if (!name.empty()) changed.lights[copy.index].name = copied_name;
      push_place(changed, "light", copy.index, way_m);
      break;
    }
    case ObjectKind::cloud:
      copy.index = duplicate_parts(changed, {{object.index, {}}}, way_m).front().cloud;
      break;
    case ObjectKind::cloud_layer:
      copy.index = append_copy(changed, object.kind, changed.cloud_layers, object.index);
      ++changed.cloud_layers[copy.index].seed;
      push_place(changed, "cloud_layer", copy.index, way_m);
      break;
    default:
      copy.index = append_copy(changed, object.kind, changed.ocean.wakes, object.index);
      push_place(changed, "ocean.wake", copy.index, way_m);
  }
  scene = std::move(changed);
  return copy;
}

void rename_object(Scene& scene, const SceneObject& object, const std::string& name) {
  const Parameter& row = *name_row(object.kind);
  const std::string before = name_of_object(scene, object);
  std::vector<std::string*> references;
  if (!before.empty() && is_first_of_its_name(scene, object, before))
    references = references_to(scene, object.kind, before);
  if (!name.empty() && name != before && has_another(scene, object, name)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a name of its own, but another {} is \"{}\"", row.key,
                            row_of(object.kind).word, one_line(name)),
                "write another name");
  }
  if (name.empty() && !references.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a name, as other sections refer to \"{}\"", row.key, before),
                "write a name");
  }
  if (name.empty()) {
    std::get<scene::ValueAt<std::string>>(row.storage)
        .in(scene::struct_at(&scene, *row.section, {object.index, 0}))
        .clear();
    return;
  }
  scene::store(scene, row, {.value = name, .shown = fmt::format("\"{}\"", one_line(name))},
               {.subject = std::string(row.key)}, ElementIndex{object.index, 0});
  for (std::string* reference : references) *reference = name;
  if (object.kind != ObjectKind::body || before.empty()) return;
  const std::optional<std::size_t> hull = hull_of_body(scene, object.index);
  if (!hull || scene.meshes[*hull].name != hull_name_of(before)) return;
  const SceneObject mesh{ObjectKind::mesh, *hull};
  if (!has_another(scene, mesh, hull_name_of(name))) rename_object(scene, mesh, hull_name_of(name));
}

}  // namespace offing::present
