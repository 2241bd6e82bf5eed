// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/ground.h"
#include "host/terrain/height_field.h"
#include "tests/bench/benches.h"
#include "tests/bench/embree_peer.h"

namespace offing::bench {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

struct NamedMap {
  std::string name;
  HeightMap map;
};

/// Valleys over the same 20 km of ground, whatever the number of posts.
HeightMap valleys(int size) {
  constexpr double side_m = 20'480.0;
  HeightMap map;
  map.columns = map.rows = size + 1;
  map.spacing_x_m = map.spacing_z_m = side_m / size;
  // Ten octaves of waves in seeded directions, half as high each as the one before.
  std::mt19937_64 random(1);
  struct Wave {
    double kx, kz, phase, height_m;
  };
  std::vector<Wave> waves;
  for (int octave = 0; octave < 10; ++octave) {
    for (int i = 0; i < 4; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(random() >> 11) * 0x1p-53;
      const double k = 2.0 * std::numbers::pi * std::exp2(octave) / 9000.0;
      waves.push_back(
          {k * std::cos(angle), k * std::sin(angle), 7.0 * i + octave, 260.0 * std::exp2(-octave)});
    }
  }
  for (int row = 0; row <= size; ++row) {
    for (int column = 0; column <= size; ++column) {
      double height_m = 0.0;
      for (const Wave& wave : waves) {
        height_m += wave.height_m * std::sin(wave.kx * column * map.spacing_x_m +
                                             wave.kz * row * map.spacing_z_m + wave.phase);
      }
      map.heights_m.push_back(static_cast<float>(height_m));
    }
  }
  return map;
}

/// Real ground, where OFFING_TEST_DATA says that there is some.
std::vector<NamedMap> real_maps() {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) return {};
  const std::filesystem::path terrain = std::filesystem::path(folder) / "terrain";
  HeightMapOptions andes;
  andes.raw_columns = andes.raw_rows = 1025;
  andes.vertical_scale = 0.1;
  andes.spacing_x_m = andes.spacing_z_m = 75.0;
  std::vector<NamedMap> maps;
  maps.push_back({"andes", read_height_map(terrain / "andes_1025_75m.r16", andes).map});
  maps.push_back({"cape_flattery", read_height_map(terrain / "N48W125.hgt.zip").map});
  return maps;
}

struct NamedCamera {
  std::string name;
  Camera camera;
};

/// Four that fly, from the middle of the southern edge on, the higher the steeper, and four that walk, at
/// seeded posts of ground and looking where it falls.
std::vector<NamedCamera> cameras(const HeightMap& map) {
  const float highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end());
  const double width_m = map.spacing_x_m * (map.columns - 1), depth_m = map.spacing_z_m * (map.rows - 1);
  std::vector<NamedCamera> all;
  constexpr std::array<std::array<double, 2>, 4> flights{
      {{300.0, -15.0}, {1000.0, -30.0}, {2000.0, -45.0}, {4000.0, -60.0}}};
  for (const auto& [above_m, pitch_deg] : flights) {
    all.push_back(
        {"fly",
         {.eye_m = {0.5 * width_m, highest_m + above_m, 0.9 * depth_m}, .pitch_rad = pitch_deg * radians}});
  }
  std::mt19937_64 random(4);
  const auto share = [&] { return 0.2 + 0.6 * static_cast<double>(random() >> 11) * 0x1p-53; };
  while (all.size() < 8) {
    // At posts triangles and bilinear patches agree.
    const double x_m = std::round(share() * (map.columns - 1)) * map.spacing_x_m;
    const double z_m = std::round(share() * (map.rows - 1)) * map.spacing_z_m;
    const terrain::GroundPoint ground = *terrain::ground_at(map, x_m, z_m);
    if (ground.normal.y > 0.9999) continue;  // water
    all.push_back({"walk",
                   {.eye_m = {x_m, ground.height_m + 1.7, z_m},
                    .yaw_rad = std::atan2(ground.normal.x, -ground.normal.z),
                    .pitch_rad = -10.0 * radians}});
  }
  return all;
}

/// Throws Error(device) where hits differ by more than triangles differ from bilinear patches: in the median
/// by 1e-4 of the distance, and in what is hit by 1 % of the pixels.
void require_equal(const std::string& name, double cell_m, const std::vector<float>& ours_m,
                   const std::vector<float>& peers_m) {
  std::vector<double> differences;
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < ours_m.size(); ++i) {
    if (std::isinf(ours_m[i]) != std::isinf(peers_m[i])) {
      ++unlike;
    } else if (!std::isinf(ours_m[i])) {
      differences.push_back(std::abs(ours_m[i] - peers_m[i]) / std::max<double>(cell_m, peers_m[i]));
    }
  }
  const double middle = differences.empty() ? 0.0 : median(differences);
  if (middle <= 1e-2 && unlike <= ours_m.size() / 100) return;
  throw Error(ErrorKind::device,
              fmt::format("{}: ours and the peer's differ by {:.2g} of the distance in the median and in {} "
                          "pixels of {}, expected 1e-2 and 1 %",
                          name, middle, unlike, ours_m.size()),
              "run the tests of this device: ctest -L quick");
}

struct Mode {
  EmbreePeer* peer;
  EmbreePeer::Packet packet;
};

/// The mode that casts this camera's rays fastest: of all once, then of the best three.
Mode fastest_mode(const Camera& camera, std::vector<Mode> modes) {
  constexpr std::size_t finalists = 3;
  const auto work_of = [&](const Mode& mode) -> Work {
    return [&camera, mode] { mode.peer->cast(camera, mode.packet); };
  };
  std::vector<std::pair<double, Mode>> timed;
  for (const Mode& mode : modes) {
    const Work work = work_of(mode);
    work();
    timed.emplace_back(once_ms(work), mode);
  }
  std::sort(timed.begin(), timed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Work> best;
  for (std::size_t i = 0; i < finalists; ++i) best.push_back(work_of(timed[i].second));
  return timed[fastest(best)].second;
}

void bench_map(const ocl::Device& device, const NamedMap& named, const Settings& settings,
               const Sinks& sinks) {
  using Geometry = EmbreePeer::Geometry;
  const HeightMap& map = named.map;
  const terrain::PostGrid grid = terrain::post_grid(map);
  terrain::HeightField field(device, grid, map.heights_m);
  EmbreePeer as_grid(grid, map.heights_m, Geometry::grid),
      as_triangles(grid, map.heights_m, Geometry::triangles);
  const Comparison built = compare(
      [&] {
        terrain::Pyramid(device, grid, field.heights_m());
        device.finish();
      },
      [&] { as_grid.build(); }, std::min(settings.blocks, 3));
  sinks.row(row_of("terrain_build_" + named.name, map.columns, "Embree 3, grid", built));
  as_triangles.build();

  std::vector<Mode> modes;
  for (EmbreePeer* peer : {&as_grid, &as_triangles}) {
    for (const EmbreePeer::Packet packet : EmbreePeer::packets) modes.push_back({peer, packet});
  }
  for (const char* way : {"fly", "walk"}) {
    double log_sum = 0.0;
    int count = 0;
    for (const NamedCamera& named_camera : cameras(map)) {
      const Camera& camera = named_camera.camera;
      if (named_camera.name != way) continue;
      const std::size_t pixels =
          static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
      ocl::Buffer<float> distances_m(device, pixels, "distances");
      const Work ours = [&] {
        field.cast(camera, distances_m);
        device.finish();
      };
      const Mode mode = fastest_mode(camera, modes);
      const Work peers = [&] { mode.peer->cast(camera, mode.packet); };
      ours();
      peers();
      const std::vector<float> found_m = distances_m.read();
      require_equal(named.name, map.spacing_x_m, found_m, mode.peer->distances_m());
      const Comparison comparison = compare(ours, peers, settings.blocks);
      const auto ground =
          std::count_if(found_m.begin(), found_m.end(), [](float t_m) { return !std::isinf(t_m); });
      sinks.note(fmt::format("{} {}: {:.0f} % ground, ours {:.1f}, peer {:.1f} Mray/s", named.name, way,
                             100.0 * static_cast<double>(ground) / static_cast<double>(pixels),
                             static_cast<double>(pixels) / 1e3 / comparison.ours_ms,
                             static_cast<double>(pixels) / 1e3 / comparison.peer_ms));
      sinks.row(row_of(fmt::format("terrain_{}_{}", way, named.name), map.columns,
                       mode.peer->name(mode.packet), comparison));
      log_sum += std::log(comparison.ratio);
      ++count;
    }
    sinks.note(fmt::format("{} {}: geometric mean of the ratios {:.2f}", named.name, way,
                           std::exp(log_sum / count)));
  }
}

}  // namespace

void bench_terrain(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_map(device, {"valleys", valleys(size)}, settings, sinks);
  for (const NamedMap& map : real_maps()) bench_map(device, map, settings, sinks);
}

}  // namespace offing::bench
