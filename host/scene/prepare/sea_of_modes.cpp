#include "host/scene/prepare/sea_of_modes.h"

#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/modes/mode_file.h"
#include "host/ocean/spectrum/mode_spectrum.h"
#include "host/ocean/surface/cascades.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {

namespace {

/// The sea's waves are those of the file alone, and an irregular swell has waves on patches too.
void refuse_irregular_swells(const Scene& scene) {
  for (std::size_t i = 0; i < scene.ocean.swells.size(); ++i) {
    if (!scene.ocean.swells[i].hs_m) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected no irregular swell beside a file of modes, found hs_m = {:g}",
                            place_of_name(scene, {std::string_view("ocean.swell.hs_m"), {i}}),
                            *scene.ocean.swells[i].hs_m),
                "remove hs_m to add one wave of amplitude_m, or give the swell to `offing ocean modes`");
  }
}

}  // namespace

Sea sea_of_modes(const Scene& scene) {
  refuse_irregular_swells(scene);
  const std::string& file = scene.ocean.modes_file;
  require_file(scene, "ocean.modes_file", file, "a file of modes");
  const auto modes = std::make_shared<const ModalSea>(read_modes(file, scene.trust));
  ocean::Dispersion dispersion = scene.ocean.spectrum.dispersion;
  dispersion.depth_m = scene.ocean.depth_m.value_or(modes->depth_m);

  Sea sea;
  sea.wind = wind_of_sea(scene);
  sea.measured = ocean::spectrum_of(*modes);
  sea.measured->station = std::filesystem::path(file).filename().string();
  sea.spectrum = ocean::from_measured(*sea.measured, scene.ocean.spectrum.spreading, dispersion);
  sea.parameters = scene.ocean.parameters;
  sea.parameters.modes = modes;
  sea.parameters.size = modes->size;
  sea.parameters.choppiness = modes->choppiness;
  sea.parameters.loop_period_s = scene.time.loop_period_s ? scene.time.loop_period_s : modes->loop_period_s;
  sea.parameters.cascades =
      ocean::cascades_from_patches(modes->patch_lengths_m, modes->size, modes->split_radpm);
  for (const SeaMode& mode : modes->modes) {
    if (mode.patch != SeaMode::alone) continue;
    sea.swells.push_back({.amplitude_m = mode.amplitude_m,
                          .wavenumber_radpm = std::hypot(mode.kx_radpm, mode.kz_radpm),
                          .direction_rad = std::atan2(mode.kz_radpm, mode.kx_radpm),
                          .omega_radps = mode.omega_radps,
                          .phase_rad = mode.phase_rad});
  }
  return sea;
}

}  // namespace offing::scene
