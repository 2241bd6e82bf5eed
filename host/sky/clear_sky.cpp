#include "host/sky/clear_sky.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/ocl/disk_cache.h"
#include "host/ocl/program.h"
#include "host/ocl/program_source.h"
#include "host/ocl/self_test.h"

namespace offing::sky {
namespace {

// Below, the horizon lies so near that its distance has no digits left in single precision.
constexpr double lowest_eye_m = 1.0;
// The march along a ray ends where the air does: an eye there would see a ray of no length.
constexpr double highest_eye_share = 0.999;
constexpr double highest_eye_m = 1e9;

constexpr std::size_t depth_columns = SKY_DEPTH_COLUMNS;
constexpr std::size_t depth_rows = SKY_DEPTH_ROWS;
constexpr std::size_t scattering_columns = SKY_SCATTERING_COLUMNS;
constexpr std::size_t scattering_rows = SKY_SCATTERING_ROWS;
constexpr std::size_t view_columns = SKY_VIEW_COLUMNS;
constexpr std::size_t view_rows = SKY_VIEW_ROWS;
constexpr std::size_t view_layers = SKY_VIEW_LAYERS;
constexpr std::size_t rings = SKY_ILLUMINANCE_RINGS;

// Room for about 30 atmospheres.
constexpr ocl::CacheKind air_tables{"air", "table of the air", 10'000'000};

Rgb rgb_of(const Texel& texel) {
  return {texel[0], texel[1], texel[2]};
}

std::vector<Rgb> read_rgb(const ocl::Buffer<Texel>& buffer) {
  const std::vector<Texel> texels = buffer.read();
  std::vector<Rgb> light(texels.size());
  std::ranges::transform(texels, light.begin(), rgb_of);
  return light;
}

void require_valid(const Sun& sun, double eye_altitude_m) {
  const auto& [x, y, z] = sun.sun_direction;
  require_within("sky.sun_direction length", std::hypot(x, y, z), 0.999, 1.001);
  require_within("sky.sun_distance_au", sun.sun_distance_au, 0.1, 100.0);
  require_within("sky.eye_altitude_m", eye_altitude_m, 0.0, highest_eye_m);
}

}  // namespace

ClearSky::ClearSky(const ocl::Device& device, const Atmosphere& atmosphere)
    : device_(device), atmosphere_(atmosphere) {
  require_valid(atmosphere);
  air_ = atmosphere_params(atmosphere);
  depth_table_ = ocl::Buffer<Texel>(device, depth_rows * depth_columns, "sky optical depth");
  scattering_table_ = ocl::Buffer<Texel>(device, scattering_rows * scattering_columns, "sky scattering");
  ground_table_ = ocl::Buffer<Texel>(device, scattering_columns, "sky ground");
  view_table_ = ocl::Buffer<Texel>(device, view_layers * view_rows * view_columns, "sky view");

  make_air_tables();
  view_kernel_ = ocl::Program::build(device, "sky/view_table.cl").kernel("view_table");
  map_kernel_ = ocl::Program::build(device, "sky/sky_map.cl").kernel("sky_map");
  rays_kernel_ = ocl::Program::build(device, "sky/sky_rays.cl").kernel("sky_rays");
  illuminance_kernel_ = ocl::Program::build(device, "sky/sky_illuminance.cl").kernel("sky_illuminance");
  at({});
}

void ClearSky::make_air_tables() {
  const std::array<ocl::ProgramRecipe, 3> programs{
      {{"sky/depth_table.cl", {}}, {"sky/scattering_table.cl", {}}, {"sky/ground_table.cl", {}}}};
  const auto asymmetry = static_cast<float>(atmosphere_.aerosol_asymmetry);
  const ocl::DiskCache cache(ocl::DiskCache::default_folder(), air_tables);
  const bool is_kept = cache.is_on() && device_.info().has_host_unified_memory;  // others are quick to make
  const std::string identity =
      !is_kept ? std::string()
               : ocl::identity_of(device_.info(), programs) +
                     ocl::joined_identity({ocl::identity_of_bytes(std::as_bytes(std::span(&air_, 1))),
                                           ocl::identity_of_bytes(std::as_bytes(std::span(&asymmetry, 1)))});
  const std::array<ocl::Buffer<Texel>*, 3> tables{&depth_table_, &scattering_table_, &ground_table_};
  std::vector<std::uint8_t> kept;
  for (const auto* table : tables) kept.resize(kept.size() + table->size() * sizeof(Texel));
  if (is_kept) {
    const std::optional<std::vector<std::uint8_t>> loaded = cache.load(identity);
    if (loaded && loaded->size() == kept.size()) {
      std::size_t begin = 0;
      for (auto* table : tables) {
        std::vector<Texel> texels(table->size());
        std::memcpy(texels.data(), loaded->data() + begin, texels.size() * sizeof(Texel));
        table->write(texels);
        begin += texels.size() * sizeof(Texel);
      }
      return;
    }
  }
  const auto kernel = [&](std::size_t program, const char* name) {
    return ocl::Program::build(device_, programs[program].source_name).kernel(name);
  };
  kernel(0, "depth_table").launch({{depth_columns, depth_rows}}, air_, depth_table_);
  kernel(1, "scattering_table")
      .launch({{scattering_columns, scattering_rows}}, air_, depth_table_, scattering_table_);
  kernel(2, "ground_table")
      .launch({{scattering_columns}}, air_, asymmetry, depth_table_, scattering_table_, ground_table_);
  if (!is_kept) return;
  std::size_t begin = 0;
  for (const auto* table : tables) {
    const std::vector<Texel> texels = table->read();
    std::memcpy(kept.data() + begin, texels.data(), texels.size() * sizeof(Texel));
    begin += texels.size() * sizeof(Texel);
  }
  cache.store(identity, kept);
}

void ClearSky::at(const Sun& sun, double eye_altitude_m) {
  require_valid(sun, eye_altitude_m);
  const auto single = [](double value) { return static_cast<float>(value); };
  const auto& [x, y, z] = sun.sun_direction;
  const double length = std::hypot(x, y, z);
  const double nearness = 1.0 / (sun.sun_distance_au * sun.sun_distance_au);
  const SunlightColour colour;
  const auto scaled = [&](double colour_klx) { return single(colour_klx * nearness); };
  params_ = {.sun_direction_x = single(x / length),
             .sun_direction_y = single(y / length),
             .sun_direction_z = single(z / length),
             .eye_altitude_m = single(
                 std::clamp(eye_altitude_m, lowest_eye_m, highest_eye_share * atmosphere_.thickness_m)),
             .ground_radius_m = air_.ground_radius_m,
             .thickness_m = air_.thickness_m,
             .aerosol_asymmetry = single(atmosphere_.aerosol_asymmetry),
             .sun_angular_radius_rad = air_.sun_angular_radius_rad,
             .red_0_klx = scaled(colour.red_klx[0]),
             .red_1_klx = scaled(colour.red_klx[1]),
             .red_2_klx = scaled(colour.red_klx[2]),
             .red_3_klx = scaled(colour.red_klx[3]),
             .green_0_klx = scaled(colour.green_klx[0]),
             .green_1_klx = scaled(colour.green_klx[1]),
             .green_2_klx = scaled(colour.green_klx[2]),
             .green_3_klx = scaled(colour.green_klx[3]),
             .blue_0_klx = scaled(colour.blue_klx[0]),
             .blue_1_klx = scaled(colour.blue_klx[1]),
             .blue_2_klx = scaled(colour.blue_klx[2]),
             .blue_3_klx = scaled(colour.blue_klx[3])};
  view_kernel_.launch({{view_columns, view_rows}}, air_, params_, depth_table_, scattering_table_,
                      ground_table_, view_table_);
  static std::atomic<std::uint64_t> revisions{0};
  revision_ = ++revisions;
}

void ClearSky::fill_map(int columns, int rows, ocl::Buffer<Texel>& map) const {
  const bool has_size = columns >= 1 && rows >= 1;
  const auto width = static_cast<std::size_t>(std::max(columns, 0));
  const auto height = static_cast<std::size_t>(std::max(rows, 0));
  if (!has_size || map.size() != width * height) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("sky map: expected {} x {} texels, both at least 1, found a buffer of {}",
                            columns, rows, map.size()),
                "make the buffer of columns * rows texels");
  }
  map_kernel_.launch({{width, height}}, params_, view_table_, columns, rows, map);
}

Illuminance ClearSky::read_illuminance() const {
  ocl::Buffer<Texel> parts(device_, rings + 1, "sky illuminance");
  illuminance_kernel_.launch({{rings + 1}}, params_, view_table_, depth_table_, parts);
  const std::vector<Rgb> light = read_rgb(parts);
  Illuminance sum{.sun_klx = light[rings]};
  for (std::size_t ring = 0; ring < rings; ++ring) {
    for (std::size_t channel = 0; channel < 3; ++channel) sum.sky_klx[channel] += light[ring][channel];
  }
  return sum;
}

SkyLight ClearSky::read_light(std::span<const std::array<double, 3>> directions) const {
  if (directions.empty()) return {};
  std::vector<Texel> rays;
  rays.reserve(directions.size());
  for (const auto& [x, y, z] : directions) {
    rays.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0.0f});
  }
  const ocl::Buffer<Texel> ray_buffer(device_, rays, "sky rays");
  ocl::Buffer<Texel> sky_light(device_, rays.size(), "sky light"),
      sun_light(device_, rays.size(), "sun light");
  rays_kernel_.launch({{rays.size()}}, params_, view_table_, depth_table_, ray_buffer, sky_light, sun_light);
  return {.sky_kcdpm2 = read_rgb(sky_light), .sun_kcdpm2 = read_rgb(sun_light)};
}

std::string clear_sky_glsl() {
  return ocl::glsl_source("sky/clear_sky.clh");
}

}  // namespace offing::sky
