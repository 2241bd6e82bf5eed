#include "host/scene/sea.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/spectra/read_spectra.h"
#include "host/scene/parameter_table.h"
#include "host/scene/spectrum_tail.h"
#include "host/scene/unused_parameters.h"

namespace offing::scene {

namespace {

WaveSpectrum read_record(const OceanScene& scene) {
  std::vector<WaveSpectrum> records = read_spectra(scene.spectrum_file);
  const auto index = static_cast<std::size_t>(scene.record);
  if (index >= records.size()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a record within [0, {}], got {}", scene.spectrum_file,
                            records.size() - 1, scene.record),
                "`offing ocean spectrum FILE` lists the records");
  }
  return std::move(records[index]);
}

}  // namespace

OceanScene with_resolved_wind(OceanScene scene) {
  scene.wind_speed_mps = scene.ocean_wind_speed_mps.value_or(scene.wind_speed_mps);
  scene.wind_direction_rad = scene.ocean_wind_direction_rad.value_or(scene.wind_direction_rad);
  return scene;
}

Sea prepare_sea(const OceanScene& scene) {
  Sea sea;
  const OceanScene resolved = with_resolved_wind(scene);
  ocean::SpectrumParameters spectrum = scene.spectrum;
  spectrum.wind_speed_mps = resolved.wind_speed_mps;
  spectrum.spreading.direction_rad = resolved.wind_direction_rad;
  if (scene.depth_m) {
    spectrum.dispersion.depth_m = *scene.depth_m;
  }
  if (scene.spectrum_file.empty()) {
    sea.spectrum = ocean::make_sea_spectrum(spectrum);
  } else {
    sea.measured = read_record(scene);
    if (!scene.depth_m && sea.measured->depth_m) {
      spectrum.dispersion.depth_m = *sea.measured->depth_m;
    }
    if (scene.tail_hz) {
      sea.measured = with_tail(std::move(*sea.measured), *scene.tail_hz);
    }
    // Only a wind that was asked for: the default would be a guess, where the record's own peak tells the
    // wave age.
    spectrum.spreading.wind_speed_mps = scene.ocean_wind_speed_mps;
    sea.spectrum = ocean::from_measured(*sea.measured, spectrum.spreading, spectrum.dispersion);
  }

  sea.parameters = scene.ocean;
  sea.parameters.cascades = scene.patch_lengths_m.empty()
                                ? ocean::choose_cascades(sea.spectrum, scene.ocean.size, scene.cascade_count)
                                : ocean::cascades_from_patches(scene.patch_lengths_m, scene.ocean.size);
  for (const std::string& line : unused_parameters(scene, sea)) {
    spdlog::warn("{}", line);
  }
  return sea;
}

std::string spectrum_name(const OceanScene& scene, const Sea& sea) {
  if (!sea.measured) {
    return fmt::format("{}, wind {:g} m/s", value_text(scene, *find_parameter("ocean.spectrum")),
                       with_resolved_wind(scene).wind_speed_mps);
  }
  std::string name = "measured";
  for (const std::string* part : {&sea.measured->station, &sea.measured->time_utc}) {
    name += part->empty() ? "" : ", " + *part;
  }
  return name;
}

}  // namespace offing::scene
