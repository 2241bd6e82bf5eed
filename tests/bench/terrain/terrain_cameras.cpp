// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/terrain/terrain_cameras.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "host/base/error.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::bench {
namespace {

constexpr double radians = std::numbers::pi / 180.0;
constexpr const char* file = OFFING_SCENES "/bench_terrain.toml";
// Ground this level is water in the real maps.
constexpr double most_level_normal = 0.9999;

Error file_error(const std::string& what) {
  return {ErrorKind::bad_input, fmt::format("{}: {}", file, what), "take the file that comes with Offing"};
}

template <class Number>
Number number(const toml::node_view<const toml::node>& table, const char* key) {
  const std::optional<Number> value = table[key].value<Number>();
  if (!value) throw file_error(fmt::format("expected a number as {}", key));
  return *value;
}

Camera of_image(const toml::table& cameras) {
  const auto picture = cameras["picture"];
  Camera camera;
  camera.width_px = number<int>(picture, "width_px");
  camera.height_px = number<int>(picture, "height_px");
  camera.vertical_field_of_view_rad = number<double>(picture, "vertical_field_of_view_deg") * radians;
  return camera;
}

Camera flying(const toml::node_view<const toml::node>& flight, Camera camera, const HeightMap& map,
              float highest_m) {
  camera.eye_m = {0.5 * map.spacing_x_m * (map.columns - 1),
                  highest_m + number<double>(flight, "above_highest_m"),
                  number<double>(flight, "from_north") * map.spacing_z_m * (map.rows - 1)};
  camera.pitch_rad = number<double>(flight, "pitch_deg") * radians;
  return camera;
}

Camera walking(Camera camera, double eye_height_m, const HeightMap& map, std::mt19937_64& random) {
  const auto share = [&] { return 0.2 + 0.6 * static_cast<double>(random() >> 11) * 0x1p-53; };
  for (;;) {
    // At posts triangles and bilinear patches agree.
    const double x_m = std::round(share() * (map.columns - 1)) * map.spacing_x_m;
    const double z_m = std::round(share() * (map.rows - 1)) * map.spacing_z_m;
    const terrain::TerrainPoint terrain = *terrain::terrain_at(map, x_m, z_m);
    if (terrain.normal.y > most_level_normal) continue;
    camera.eye_m = {x_m, terrain.height_m + eye_height_m, z_m};
    camera.yaw_rad = std::atan2(terrain.normal.x, -terrain.normal.z);
    return camera;
  }
}

}  // namespace

std::vector<TerrainCamera> terrain_cameras(const HeightMap& map) {
  toml::table scene;
  try {
    scene = toml::parse_file(file);
  } catch (const toml::parse_error& error) {
    throw file_error(std::string(error.description()));
  }
  const toml::table* of_bench = scene["bench"].as_table();
  if (of_bench == nullptr) throw file_error("expected a section [bench]");
  const toml::table& cameras = *of_bench;
  const toml::array* flights = cameras["fly"].as_array();
  if (flights == nullptr) throw file_error("expected tables [[bench.fly]]");
  const float highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end());
  std::vector<TerrainCamera> all;
  for (const toml::node& flight : *flights) {
    all.push_back(
        {"fly", flying(toml::node_view<const toml::node>(flight), of_image(cameras), map, highest_m)});
  }
  const auto walk = cameras["walk"];
  std::mt19937_64 random(number<std::uint64_t>(walk, "seed"));
  for (int i = 0; i < number<int>(walk, "count"); ++i) {
    Camera camera = of_image(cameras);
    camera.pitch_rad = number<double>(walk, "pitch_deg") * radians;
    all.push_back({"walk", walking(camera, number<double>(walk, "eye_height_m"), map, random)});
  }
  return all;
}

}  // namespace offing::bench
