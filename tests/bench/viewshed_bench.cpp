// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/viewshed.h"
#include "tests/bench/benches.h"
#include "tests/bench/terrain_maps.h"
#include "tests/terrain/gdal_viewshed.h"

namespace offing::bench {
namespace {

/// The peer's sweep is an approximation: throws Error(device) where more than 2 % of the posts differ.
void require_alike(const std::string& name, const std::vector<std::uint8_t>& ours,
                   const std::vector<std::uint8_t>& peers) {
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) unlike += ours[i] == peers[i] ? 0 : 1;
  if (unlike <= ours.size() / 50) return;
  throw Error(ErrorKind::device,
              fmt::format("{}: expected at most 2 % of the posts to differ from the peer's, found {} of {}",
                          name, unlike, ours.size()),
              "run the tests of this device: ctest -L quick");
}

void bench_map(const ocl::Device& device, const NamedMap& named, const Settings& settings,
               const Sinks& sinks) {
  const HeightMap& map = named.map;
  const terrain::HeightField field(device, terrain::post_grid(map), map.heights_m);
  const terrain::Viewshed viewshed(device);
  const test::GdalViewshed gdal(map);
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
    require_alike(name, ours, peers);
    sinks.row(row_of(name, map.columns, "GDAL viewshed", compare(our_work, peer_work, settings.blocks)));
  }
}

}  // namespace

void bench_viewshed(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_map(device, valleys(size), settings, sinks);
  for (const NamedMap& map : real_maps(RealMaps::andes_and_cape_flattery))
    bench_map(device, map, settings, sinks);
}

}  // namespace offing::bench
