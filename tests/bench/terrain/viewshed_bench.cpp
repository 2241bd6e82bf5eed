// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/analysis/viewshed.h"
#include "tests/bench/benches.h"
#include "tests/bench/terrain/terrain_maps.h"
#include "tests/terrain/analysis/gdal_viewshed.h"
#include "tests/terrain/analysis/sight_reference.h"

namespace offing::bench {
namespace {

// Of the posts that differ, those that are looked at; of all posts, those by which the peer is judged.
constexpr std::size_t most_judged = 2000, most_sampled = 10'000;
// What a post's line clears the ground by where rounding decides, m
// (tests/terrain/analysis/viewshed_data_test.cpp).
constexpr double rounding_m = 1e-3;

/// Whether a post is seen, in double precision; nothing where rounding decides.
std::optional<bool> is_surely_seen(const test::HeightMap& map, const terrain::ViewshedParameters& parameters,
                                   std::size_t post) {
  const auto columns = static_cast<std::size_t>(map.grid.columns);
  const double clearance_m = test::reference_clearance_m(map, parameters, static_cast<int>(post % columns),
                                                         static_cast<int>(post / columns));
  return std::abs(clearance_m) > rounding_m ? std::optional(clearance_m >= 0.0) : std::nullopt;
}

/// The peer with the shares of posts that are wrong, of some all over the map.
std::string peer_with_wrong_posts(const test::HeightMap& map, const terrain::ViewshedParameters& parameters,
                                  const std::vector<std::uint8_t>& ours,
                                  const std::vector<std::uint8_t>& peers) {
  // Of no row and no column more than of others.
  const auto columns = static_cast<std::size_t>(map.grid.columns);
  std::size_t step = std::max<std::size_t>(1, ours.size() / most_sampled);
  while (std::gcd(step, columns) > 1) ++step;
  std::size_t sampled = 0, ours_wrong = 0, peers_wrong = 0;
  for (std::size_t post = 0; post < ours.size(); post += step) {
    ++sampled;
    const std::optional<bool> is_seen = is_surely_seen(map, parameters, post);
    if (!is_seen) continue;
    ours_wrong += *is_seen != (ours[post] == 255) ? 1 : 0;
    peers_wrong += *is_seen != (peers[post] == 255) ? 1 : 0;
  }
  const auto percent = [&](std::size_t wrong) {
    return 100.0 * static_cast<double>(wrong) / static_cast<double>(sampled);
  };
  return fmt::format("GDAL viewshed; wrong posts: ours {:.3g} %, GDAL {:.3g} %", percent(ours_wrong),
                     percent(peers_wrong));
}

/// The peer's sweep is an approximation, the coarser the fewer posts a ridge has: posts that differ are
/// judged in double precision. Throws Error(device) where ours are wrong.
void require_right(const std::string& name, const test::HeightMap& map,
                   const terrain::ViewshedParameters& parameters, const std::vector<std::uint8_t>& ours,
                   const std::vector<std::uint8_t>& peers, const Sinks& sinks) {
  std::vector<std::size_t> unlike;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i] != peers[i]) unlike.push_back(i);
  }
  const std::size_t step = std::max<std::size_t>(1, unlike.size() / most_judged);
  std::size_t judged = 0, wrong = 0;
  for (std::size_t i = 0; i < unlike.size(); i += step) {
    const std::optional<bool> is_seen = is_surely_seen(map, parameters, unlike[i]);
    ++judged;
    wrong += is_seen && *is_seen != (ours[unlike[i]] == 255) ? 1 : 0;
  }
  if (wrong > 0) {
    throw Error(
        ErrorKind::device,
        fmt::format("{}: expected posts that differ from the peer's to be right, found {} of {} wrong", name,
                    wrong, judged),
        "run the tests of this device: ctest -L quick");
  }
  sinks.note(fmt::format(
      "{}: {} of {} posts differ from the peer's; {} were judged in double precision, and ours are "
      "right",
      name, unlike.size(), ours.size(), judged));
}

void bench_viewsheds(const ocl::Device& device, const NamedMap& named, const Settings& settings,
                     const Sinks& sinks) {
  const HeightMap& map = named.map;
  const terrain::HeightField field(device, terrain::post_grid(map), map.heights_m);
  const terrain::Viewshed viewshed(device);
  const test::GdalViewshed gdal(map);
  const test::HeightMap on_host{named.name, terrain::post_grid(map), map.heights_m};
  ocl::Buffer<std::uint8_t> seen(device, map.heights_m.size(), "viewshed");
  std::vector<std::uint8_t> ours(seen.size()), peers;
  // From a mast, over all of the map.
  terrain::ViewshedParameters parameters{
      .observer_x_m = std::round(0.43 * (map.columns - 1)) * map.spacing_x_m,
      .observer_z_m = std::round(0.61 * (map.rows - 1)) * map.spacing_z_m,
      .observer_height_m = 30.0};
  for (const bool is_curved : {false, true}) {
    if (is_curved) parameters.curve = {terrain::earth_radius_m, terrain::light_refraction};
    const std::string name = fmt::format("viewshed_{}{}", named.name, is_curved ? "_curved" : "");
    const Work our_work = [&] {
      viewshed.at(field, parameters, seen);
      seen.read(ours);
    };
    const Work peer_work = [&] { peers = gdal.at(parameters); };
    our_work();
    peer_work();
    require_right(name, on_host, parameters, ours, peers, sinks);
    const std::string peer = peer_with_wrong_posts(on_host, parameters, ours, peers);
    sinks.row(row_of(name, map.columns, peer, compare(our_work, peer_work, settings.blocks)));
  }
}

}  // namespace

void bench_viewshed(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_viewsheds(device, valleys(size), settings, sinks);
  for (const NamedMap& map : real_maps(RealMaps::andes_and_cape_flattery))
    bench_viewsheds(device, map, settings, sinks);
}

}  // namespace offing::bench
