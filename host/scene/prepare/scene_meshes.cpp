#include "host/scene/prepare/scene_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/io/png_image.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/mesh_data.h"
#include "host/scene/prepare/mesh_motion.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/schema/scene_elements.h"
#include "host/sky/sun_position.h"

namespace offing::scene {

namespace {

using highlights::HighlightRule;
using highlights::HighlightTexture;
using highlights::Source;

constexpr std::string_view sun_name = "sun";

bool needs_image(const HighlightScene& highlight) {
  return is_image(highlight.rule.controls.texture);
}

bool has_ramp(const MeshScene& mesh) {
  return mesh.material.shading == world::BaseShading::cartoon && !mesh.cartoon_ramp.empty();
}

struct NamedImage {
  std::string file;
  ValueKey named_by;
};

/// Each file once, in the order of the scene.
std::vector<NamedImage> named_images(const Scene& scene) {
  std::vector<NamedImage> pictures;
  const auto add = [&](const std::string& file, const ValueKey& named_by) {
    if (std::ranges::find(pictures, file, &NamedImage::file) == pictures.end())
      pictures.push_back({file, named_by});
  };
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (has_ramp(scene.meshes[mesh])) add(scene.meshes[mesh].cartoon_ramp, {"mesh.cartoon_ramp", {mesh, 0}});
    for (std::size_t i = 0; i < scene.meshes[mesh].highlights.size(); ++i) {
      const HighlightScene& highlight = scene.meshes[mesh].highlights[i];
      if (needs_image(highlight)) add(highlight.picture, {"mesh.highlight.picture", {mesh, i}});
    }
  }
  return pictures;
}

std::vector<std::string> image_files(const Scene& scene) {
  std::vector<std::string> files;
  for (const NamedImage& picture : named_images(scene)) files.push_back(picture.file);
  return files;
}

/// The index of a highlight's light among the lights; the sun is behind all of them.
std::optional<int> light_of(const Scene& scene, ElementIndex element) {
  const std::string& name = scene.meshes[element.outer].highlights[element.inner].light;
  if (name.empty()) return std::nullopt;
  const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [&](const LightScene& each) { return each.name == name; });
  if (light == scene.lights.end() && name != sun_name) {
    std::vector<std::string> names{std::string(sun_name)};
    for (const LightScene& each : scene.lights) {
      if (!each.name.empty()) names.push_back(each.name);
    }
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected the name of a [[light]] or sun, got \"{}\"",
                            place_of_name(scene, {"mesh.highlight.light", element}), name),
                hint_of_names(name, names, ""));
  }
  return static_cast<int>(light - scene.lights.begin());
}

/// Index of a picture that named_images() has.
int image_of(const Scene& scene, const std::string& file) {
  const std::vector<std::string> files = image_files(scene);
  return static_cast<int>(std::find(files.begin(), files.end(), file) - files.begin());
}

/// Highlights name lights: a name is to mean one.
void require_distinct_names(const Scene& scene) {
  std::set<std::string_view> known{sun_name};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const std::string& name = scene.lights[i].name;
    if (name.empty() || known.insert(name).second) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a name that no other light has, got \"{}\"",
                            place_of_name(scene, {"light.name", {i, 0}}), name),
                "give each [[light]] a name of its own; sun is the sun's");
  }
}

Source source_of(const LightScene& light) {
  if (light.kind == LightKind::place) return {Source::Kind::place, light.place_m};
  const auto [x, y, z] = sky::direction_of(light.azimuth_rad, light.elevation_rad);
  return {Source::Kind::direction, {x, y, z}};
}

/// Meshes or lights of a scene at a time; nothing else of it.
Scene moment_of(const Scene& scene, double time_s, ParameterGroup group) {
  Scene moment;
  if (group == ParameterGroup::light) {
    moment.lights = scene.lights;
  } else {
    moment.meshes = scene.meshes;
  }
  move_to(moment, scene, time_s, {group});
  return moment;
}

world::MeshParameters parameters_of(const Scene& scene, std::size_t index, const MeshData& data) {
  const MeshScene& mesh = scene.meshes[index];
  world::MeshParameters parameters;
  parameters.name = mesh.name.empty() ? fmt::format("mesh {}", index + 1) : mesh.name;
  parameters.mesh = data.mesh;
  parameters.curvatures = data.curvatures;
  parameters.deformation = data.deformation;
  parameters.motion = motion_of(scene, index);
  parameters.surface.smoothing_rounds = mesh.smoothing_rounds;
  parameters.has_highlights = mesh.shown == MeshHighlights::on;
  parameters.tracks.size = {.threshold = mesh.threshold,
                            .cap_radius_m = mesh.cap_radius_m.value_or(0.0),
                            .flat_limit = mesh.flat_limit};
  return parameters;
}

std::vector<world::MeshParameters> with_moment(std::vector<world::MeshParameters> meshes,
                                               const Scene& scene) {
  const std::vector<world::MeshMaterial> materials = mesh_materials_at(scene, scene.time.start_s);
  std::vector<std::vector<HighlightRule>> rules = mesh_rules_at(scene, scene.time.start_s);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes[i].material = materials[i];
    meshes[i].rules = std::move(rules[i]);
  }
  return meshes;
}

bool is_same_form(const MeshScene& a, const MeshScene& b) {
  return a.file == b.file && a.shape == b.shape && a.size_m == b.size_m && a.detail == b.detail &&
         a.scale == b.scale && a.animation == b.animation && a.repeats == b.repeats &&
         a.sequence_frames_per_s == b.sequence_frames_per_s;
}

}  // namespace

bool are_other_meshes(const Scene& before, const Scene& after) {
  return differ_in(Affects::meshes, before, after);
}

std::vector<world::MeshParameters> prepare_meshes(const Scene& scene) {
  std::vector<world::MeshParameters> meshes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    meshes.push_back(parameters_of(scene, i, mesh_data(scene, i)));
  }
  return with_moment(std::move(meshes), scene);
}

std::vector<std::shared_ptr<const RgbaImage>> prepare_images(const Scene& scene) {
  std::vector<std::shared_ptr<const RgbaImage>> pictures;
  for (const NamedImage& picture : named_images(scene)) {
    if (picture.file.empty()) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a mesh.highlight.picture beside it, found none",
                              place_of_name(scene, {"mesh.highlight.texture", picture.named_by.element})),
                  "write picture = \"moon.png\" below it, or choose a shape");
    }
    pictures.push_back(read_named(scene, picture.named_by, "a PNG picture", picture.file, [&] {
      return std::make_shared<const RgbaImage>(read_png_with_alpha(picture.file));
    }));
  }
  return pictures;
}

std::vector<world::MeshMaterial> mesh_materials_at(const Scene& scene, double time_s) {
  std::vector<world::MeshMaterial> materials;
  for (const MeshScene& mesh : moment_of(scene, time_s, ParameterGroup::mesh).meshes) {
    materials.push_back(mesh.material);
    if (has_ramp(mesh)) materials.back().cartoon_ramp = image_of(scene, mesh.cartoon_ramp);
  }
  return materials;
}

std::vector<std::vector<HighlightRule>> mesh_rules_at(const Scene& scene, double time_s) {
  const Scene moment = moment_of(scene, time_s, ParameterGroup::highlight);
  std::vector<std::vector<HighlightRule>> rules(scene.meshes.size());
  for (std::size_t mesh = 0; mesh < rules.size(); ++mesh) {
    for (std::size_t i = 0; i < scene.meshes[mesh].highlights.size(); ++i) {
      const HighlightScene& highlight = moment.meshes[mesh].highlights[i];
      HighlightRule& rule = rules[mesh].emplace_back(highlight.rule);
      rule.light = light_of(scene, {mesh, i});
      rule.controls.picture = needs_image(highlight) ? image_of(scene, highlight.picture) : -1;
    }
  }
  return rules;
}

std::vector<world::Light> lights_at(const Scene& scene, double time_s) {
  require_distinct_names(scene);
  std::vector<world::Light> lights;
  for (const LightScene& light : moment_of(scene, time_s, ParameterGroup::light).lights) {
    lights.push_back({source_of(light), light.colour, light.illuminance_klx});
  }
  return lights;
}

namespace {

/// What meshes look like at one time, and what lights them.
struct Looks {
  std::vector<world::Light> lights;
  std::vector<world::MeshMaterial> materials;
  std::vector<std::vector<HighlightRule>> rules;
};

/// All that may throw.
Looks looks_at(const Scene& scene, double time_s) {
  return {lights_at(scene, time_s), mesh_materials_at(scene, time_s), mesh_rules_at(scene, time_s)};
}

void set_looks(world::World& world, Looks looks) {
  world.set_lights(looks.lights);
  for (std::size_t i = 0; i < world.meshes().size(); ++i) {
    world.meshes()[i].set_material(looks.materials[i]);
    world.meshes()[i].set_rules(std::move(looks.rules[i]));
  }
}

}  // namespace

void set_meshes_at(world::World& world, const Scene& scene, double time_s) {
  set_looks(world, looks_at(scene, time_s));
}

highlights::LightingAt lighting_of(const Scene& scene, const world::WorldTerrain* terrain) {
  const auto own = std::make_shared<const Scene>(scene);
  return [own, terrain](double time_s) {
    ViewScene view = view_at(*own, time_s);
    if (terrain != nullptr) stand_on_ground(*terrain, view);
    highlights::Lighting lighting{.eye = {Source::Kind::place, view.camera.eye_m}, .lights = {}};
    for (const world::Light& light : lights_at(*own, time_s)) lighting.lights.push_back(light.source);
    const auto [x, y, z] = sun_of(view).sun_direction;
    if (y > 0.0) lighting.lights.push_back({Source::Kind::direction, {x, y, z}});
    return lighting;
  };
}

void edit_meshes(world::World& world, const Scene& before, const Scene& after) {
  Looks looks = looks_at(after, after.time.start_s);
  std::optional<std::vector<std::shared_ptr<const RgbaImage>>> pictures;
  if (image_files(before) != image_files(after)) pictures = prepare_images(after);
  if (are_other_meshes(before, after)) {
    std::vector<world::MeshParameters> meshes;
    for (std::size_t i = 0; i < after.meshes.size(); ++i) {
      const bool is_known = i < before.meshes.size() && is_same_form(before.meshes[i], after.meshes[i]);
      const world::MeshParameters* known = is_known ? &world.parameters().meshes[i] : nullptr;
      meshes.push_back(parameters_of(
          after, i,
          known ? MeshData{known->mesh, known->curvatures, known->deformation} : mesh_data(after, i)));
    }
    world.set_meshes(with_moment(std::move(meshes), after));
  }
  if (pictures) world.set_images(std::move(*pictures));
  set_looks(world, std::move(looks));
}

void look_at_meshes(const std::vector<world::MeshParameters>& meshes, double time_s, Camera& camera) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const world::MeshParameters& mesh : meshes) {
    const highlights::RigidMotion motion = mesh.motion(time_s);
    const MeshForm form = mesh.deformation ? mesh.deformation.form_at(time_s) : MeshForm{};
    for (const glm::dvec3& place_m : mesh.deformation ? form.positions_m : mesh.mesh->positions_m) {
      const glm::dvec3 there_m = motion.rotation * place_m + motion.translation_m;
      low = glm::min(low, there_m);
      high = glm::max(high, there_m);
    }
  }
  constexpr double rise = 0.2;          // of the distance: from a little above
  constexpr double lowest_eye_m = 0.1;  // above the water
  const glm::dvec3 middle_m = 0.5 * (low + high);
  const double distance_m =
      0.55 * glm::distance(low, high) / std::sin(0.5 * camera.vertical_field_of_view_rad);
  camera.eye_m = middle_m + distance_m * glm::normalize(glm::dvec3(0.0, rise, 1.0));
  camera.eye_m.y = std::max(camera.eye_m.y, lowest_eye_m);
  const glm::dvec3 way_m = middle_m - camera.eye_m;
  camera.yaw_rad = 0.0;
  camera.pitch_rad = std::atan2(way_m.y, -way_m.z);
}

}  // namespace offing::scene
