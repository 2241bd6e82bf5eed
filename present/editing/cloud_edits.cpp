#include "present/editing/cloud_edits.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/objects/pushed_value.h"

namespace offing::present {
namespace {

using scene::CloudScene;
using scene::Scene;

void move_cloud(Scene& scene, std::size_t index, const glm::dvec3& way_m) {
  const double altitude_m = scene::cloud_parameters_of(scene, index).position_m.y;
  CloudScene& cloud = scene.clouds[index];
  if (way_m.y != 0.0 && !cloud.altitude_m) cloud.altitude_m = altitude_m;
  for (const auto& [key, way] :
       {std::pair("cloud.x_m", way_m.x), {"cloud.y_m", way_m.y}, {"cloud.z_m", way_m.z}}) {
    push_value(scene, key, {index, 0}, way);
  }
}

/// Throws Error(bad_usage) where a section has all the elements that it may.
void require_room(const char* key, std::size_t count) {
  const scene::Parameter& row = *scene::find_parameter(key);
  if (count < row.max_count) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("[[{}]]: expected at most {}", scene::section_of(row.key), row.max_count),
              "remove some first");
}

void copy_keys(Scene& scene, std::size_t from, std::size_t to) {
  std::vector<std::pair<scene::ValueKey, KeyframeTrack>> copies;
  for (const auto& [key, track] : scene.tracks) {
    if (scene::find_parameter(key.key)->group != scene::ParameterGroup::cloud || key.element.outer != from)
      continue;
    scene::ValueKey copy = key;
    copy.element.outer = to;
    copies.emplace_back(copy, track);
  }
  scene.tracks.insert(copies.begin(), copies.end());
}

}  // namespace

bool is_hidden(const Scene& scene, std::size_t cloud) {
  return scene.clouds[cloud].visible == scene::CloudVisibility::off;
}

bool has_part(const Scene& scene, const CloudPart& part) {
  if (part.cloud >= scene.clouds.size()) return false;
  if (!part.ball) return true;
  const CloudScene& cloud = scene.clouds[part.cloud];
  if (cloud.shape.is_given()) return false;
  const std::size_t count =
      cloud.balls.empty() ? scene::cloud_parameters_of(scene, part.cloud).balls.size() : cloud.balls.size();
  return *part.ball < count;
}

glm::dvec3 origin_of_cloud(const Scene& scene, std::size_t cloud, double time_s) {
  return clouds::cloud_origin_m(scene::cloud_parameters_of(scene, cloud), time_s);
}

std::vector<Sphere> balls_of(const Scene& scene, std::size_t cloud, double time_s) {
  if (scene.clouds[cloud].shape.is_given()) return {};
  const clouds::CloudParameters parameters = scene::cloud_parameters_of(scene, cloud);
  const glm::dvec3 origin_m = clouds::cloud_origin_m(parameters, time_s);
  std::vector<Sphere> spheres;
  for (const clouds::Metaball& ball : parameters.balls) {
    spheres.push_back({origin_m + ball.centre_m, ball.radius_m});
  }
  return spheres;
}

std::vector<clouds::Metaball>& own_balls(Scene& scene, std::size_t index) {
  CloudScene& cloud = scene.clouds[index];
  if (!cloud.balls.empty()) return cloud.balls;
  const clouds::CloudParameters parameters = scene::cloud_parameters_of(scene, index);
  cloud.balls = parameters.balls;
  for (clouds::Metaball& ball : cloud.balls) {
    ball.centre_m /= cloud.scale;
    ball.radius_m /= cloud.scale;
  }
  // The genus' base is that of its own balls, which these are now.
  if (parameters.base_m) cloud.base_m = *parameters.base_m / cloud.scale;
  return cloud.balls;
}

void move_part(Scene& scene, const CloudPart& part, const glm::dvec3& way_m) {
  if (!part.ball) {
    move_cloud(scene, part.cloud, way_m);
    return;
  }
  glm::dvec3& centre_m = own_balls(scene, part.cloud)[*part.ball].centre_m;
  centre_m += way_m / scene.clouds[part.cloud].scale;
  centre_m = {within_range("cloud.ball.x_m", centre_m.x), within_range("cloud.ball.y_m", centre_m.y),
              within_range("cloud.ball.z_m", centre_m.z)};
}

void resize_part(Scene& scene, const CloudPart& part, double ratio) {
  if (part.ball) {
    double& radius_m = own_balls(scene, part.cloud)[*part.ball].radius_m;
    radius_m = within_range("cloud.ball.radius_m", ratio * radius_m);
  } else {
    double& scale = scene.clouds[part.cloud].scale;
    scale = within_range("cloud.scale", ratio * scale);
  }
}

void remove_parts(Scene& scene, std::vector<CloudPart> parts) {
  // The last ones first, so that those before them keep their numbers; a cloud goes after its balls.
  std::sort(parts.begin(), parts.end(), [](const CloudPart& a, const CloudPart& b) {
    if (a.cloud != b.cloud) return a.cloud > b.cloud;
    return a.ball.value_or(0) > b.ball.value_or(0) || (a.ball && !b.ball);
  });
  std::optional<std::size_t> gone;  // the cloud that was taken away last
  const auto remove_cloud = [&](std::size_t cloud) {
    scene::remove_element(scene, *scene::find_parameter("cloud.name")->section, {cloud, 0});
    gone = cloud;
  };
  for (const CloudPart& part : parts) {
    if (gone == part.cloud) continue;
    if (!part.ball) {
      remove_cloud(part.cloud);
      continue;
    }
    std::vector<clouds::Metaball>& balls = own_balls(scene, part.cloud);
    balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(*part.ball));
    // Without a ball of its own it would get those of its genus again.
    if (balls.empty()) remove_cloud(part.cloud);
  }
}

std::vector<CloudPart> duplicate_parts(Scene& scene, const std::vector<CloudPart>& parts,
                                       const glm::dvec3& way_m) {
  Scene changed = scene;  // where there is no room for all nothing has changed
  std::vector<CloudPart> copies;
  for (const CloudPart& part : parts) {
    if (part.ball) {
      std::vector<clouds::Metaball>& balls = own_balls(changed, part.cloud);
      require_room("cloud.ball.radius_m", balls.size());
      balls.push_back(clouds::Metaball(balls[*part.ball]));
      copies.push_back({part.cloud, balls.size() - 1});
    } else {
      require_room("cloud.name", changed.clouds.size());
      changed.clouds.push_back(CloudScene(changed.clouds[part.cloud]));
      copies.push_back({changed.clouds.size() - 1, {}});
      copy_keys(changed, part.cloud, copies.back().cloud);
    }
    move_part(changed, copies.back(), way_m);
  }
  scene = std::move(changed);
  return copies;
}

CloudPart add_ball(Scene& scene, std::optional<std::size_t> cloud, clouds::Genus genus, const Sphere& ball,
                   double time_s) {
  const bool is_first = !cloud;
  Scene changed = scene;  // where there is no room nothing has changed
  const std::size_t index = is_first ? add_cloud(changed, genus, ball.centre_m).cloud : *cloud;
  if (changed.clouds[index].shape.is_given()) {
    throw Error(ErrorKind::bad_usage, "cloud.ball: expected a cloud of balls, found one with a shape",
                "pick a cloud without a file, a mesh, a text or a shape first, or none for a new one");
  }
  std::vector<clouds::Metaball>& balls = is_first ? changed.clouds[index].balls : own_balls(changed, index);
  require_room("cloud.ball.radius_m", balls.size());
  const double scale = changed.clouds[index].scale;
  const glm::dvec3 way_m = ball.centre_m - origin_of_cloud(changed, index, time_s);
  balls.push_back({.centre_m = is_first ? glm::dvec3(0.0) : way_m / scale,
                   .radius_m = within_range("cloud.ball.radius_m", ball.radius_m / scale)});
  const std::size_t last = balls.size() - 1;
  scene = std::move(changed);
  return {index, last};
}

CloudPart add_cloud(Scene& scene, clouds::Genus genus, const glm::dvec3& place_m) {
  require_room("cloud.name", scene.clouds.size());
  // A first cloud does not take the sea away.
  scene.ocean.is_given = scene.has_sea();
  CloudScene cloud;
  cloud.genus = genus;
  cloud.position_m = {within_range("cloud.x_m", place_m.x), 0.0, within_range("cloud.z_m", place_m.z)};
  cloud.altitude_m = within_range("cloud.y_m", place_m.y);
  cloud.seed = scene.clouds.size() + 1;
  scene.clouds.push_back(std::move(cloud));
  return {scene.clouds.size() - 1, {}};
}

void apply_genus(Scene& scene, std::size_t index, clouds::Genus genus) {
  CloudScene& cloud = scene.clouds[index];
  CloudScene plain;
  plain.name = std::move(cloud.name);
  plain.genus = genus;
  plain.position_m = cloud.position_m;
  plain.altitude_m = cloud.altitude_m;
  plain.seed = cloud.seed;
  plain.scale = cloud.scale;
  plain.shape = std::move(cloud.shape);
  plain.motion = cloud.motion;
  plain.balls = std::move(cloud.balls);
  if (!plain.balls.empty()) plain.base_m = cloud.base_m;
  plain.edits = std::move(cloud.edits);
  cloud = std::move(plain);
}

}  // namespace offing::present
