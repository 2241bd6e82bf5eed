// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/field/height_field.h"
#include "tests/bench/benches.h"
#include "tests/bench/peers/embree_peer.h"
#include "tests/bench/terrain/terrain_cameras.h"
#include "tests/bench/terrain/terrain_frames.h"
#include "tests/bench/terrain/terrain_maps.h"
#include "tests/bench/terrain/terrain_steps.h"

namespace offing::bench {
namespace {

/// Throws Error(device) where hits differ by more than triangles differ from bilinear patches: in the median
/// by 1e-2 of the distance, as of the nearest cells, whose diagonals triangles choose, and in what is hit by
/// 1 % of the pixels.
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

/// Throws Error(device) where methods hit differently by more than 1e-3 cells across the surface, or in more
/// than the rays that touch it.
void require_agreement(const std::string& name, const CameraSteps& steps) {
  if (steps.worst_cells <= 1e-3 && steps.unlike <= steps.rays / 10'000) return;
  throw Error(ErrorKind::device,
              fmt::format("{}: methods differ by {:.2g} cells and in {} of {} rays, expected 1e-3 and one in "
                          "10,000",
                          name, steps.worst_cells, steps.unlike, steps.rays),
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

struct Peers {
  EmbreePeer as_grid, as_triangles;

  Peers(const terrain::PostGrid& grid, const std::vector<float>& heights_m)
      : as_grid(grid, heights_m, EmbreePeer::Geometry::grid),
        as_triangles(grid, heights_m, EmbreePeer::Geometry::triangles) {}

  std::vector<Mode> modes() {
    std::vector<Mode> modes;
    for (EmbreePeer* peer : {&as_grid, &as_triangles}) {
      for (const EmbreePeer::Packet packet : EmbreePeer::packets) modes.push_back({peer, packet});
    }
    return modes;
  }
};

/// All that a map needs before its first ray, from heights in host memory, and the pyramid alone against the
/// peer's build.
void bench_build(const ocl::Device& device, const NamedMap& named, const terrain::HeightField& field,
                 EmbreePeer& peer, const Settings& settings, const Sinks& sinks) {
  const int blocks = std::min(settings.blocks, 3);
  const Comparison pyramid = compare(
      [&] {
        terrain::Pyramid(device, field.grid(), field.heights_m());
        device.finish();
      },
      [&] { peer.build(); }, blocks);
  sinks.row(row_of("terrain_build_" + named.name, named.map.columns, peer.name(), pyramid));
  const Comparison all = compare(
      [&] {
        terrain::HeightField(device, field.grid(), named.map.heights_m);
        device.finish();
      },
      [&] { peer.build(); }, blocks);
  sinks.row(row_of("terrain_load_" + named.name, named.map.columns, peer.name(), all));
  const double map_bytes = 4.0 * static_cast<double>(named.map.heights_m.size());
  const double pyramid_bytes = 4.0 * static_cast<double>(field.pyramid().maxima_m().size());
  sinks.note(fmt::format("{} {}: pyramid {:.1f} MB, {:.2f} of the height map; {:.2f} with it", named.name,
                         named.map.columns, pyramid_bytes / 1e6, pyramid_bytes / map_bytes,
                         1.0 + pyramid_bytes / map_bytes));
}

/// A row a camera; geometric mean of the ratios by the note sink.
void bench_cameras(const ocl::Device& device, const NamedMap& named, const std::string& way,
                   terrain::HeightField& field, const std::vector<Mode>& modes, const Settings& settings,
                   const Sinks& sinks) {
  double log_sum = 0.0;
  int count = 0;
  for (const auto& [camera_way, camera] : terrain_cameras(named.map)) {
    if (camera_way != way) continue;
    const auto pixels =
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
    require_equal(named.name, named.map.spacing_x_m, found_m, mode.peer->distances_m());
    const Comparison comparison = compare(ours, peers, settings.blocks);
    const auto terrain =
        std::count_if(found_m.begin(), found_m.end(), [](float t_m) { return !std::isinf(t_m); });
    sinks.note(fmt::format("{} {} {}: {:.0f} % ground, ours {:.1f}, peer {:.1f} Mray/s", named.name,
                           named.map.columns, way,
                           100.0 * static_cast<double>(terrain) / static_cast<double>(pixels),
                           static_cast<double>(pixels) / 1e3 / comparison.ours_ms,
                           static_cast<double>(pixels) / 1e3 / comparison.peer_ms));
    sinks.row(row_of(fmt::format("terrain_{}_{}", way, named.name), named.map.columns,
                     mode.peer->name(mode.packet), comparison));
    log_sum += std::log(comparison.ratio);
    ++count;
  }
  sinks.note(fmt::format("{} {} {}: geometric mean of the ratios {:.2f}", named.name, named.map.columns, way,
                         std::exp(log_sum / count)));
}

void bench_rays(const ocl::Device& device, const NamedMap& named, const Settings& settings,
                const Sinks& sinks) {
  const terrain::PostGrid grid = terrain::post_grid(named.map);
  terrain::HeightField field(device, grid, named.map.heights_m);
  Peers peers(grid, named.map.heights_m);
  bench_build(device, named, field, peers.as_grid, settings, sinks);
  peers.as_triangles.build();
  for (const char* way : {"fly", "walk"}) {
    bench_cameras(device, named, way, field, peers.modes(), settings, sinks);
  }
  bench_terrain_frames(device, named, field, settings, sinks);
  for (const CameraSteps& steps : camera_steps(field, device, terrain_cameras(named.map))) {
    require_agreement(named.name, steps);
    for (const auto& [method, of, ms] : steps.methods) {
      sinks.row({.name = fmt::format("terrain_{}_{}_{}", steps.way, named.name, method),
                 .size = named.map.columns,
                 .ours_ms = ms,
                 .peer = text_of(of),
                 .steps = of});
    }
  }
}

}  // namespace

void bench_terrain(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_rays(device, valleys(size), settings, sinks);
  for (const NamedMap& map : real_maps(RealMaps::andes_and_cape_flattery))
    bench_rays(device, map, settings, sinks);
}

}  // namespace offing::bench
