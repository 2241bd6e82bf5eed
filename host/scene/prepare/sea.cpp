#include "host/scene/prepare/sea.h"

#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/file_presence.h"
#include "host/io/spectra/read_spectra.h"
#include "host/ocean/spectrum/fetch_laws.h"
#include "host/ocean/spectrum/mixed_sea.h"
#include "host/ocean/spectrum/spreading.h"
#include "host/scene/prepare/sea_of_modes.h"
#include "host/scene/prepare/spectrum_tail.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/unused_parameters.h"

namespace offing::scene {

namespace {

WaveSpectrum read_record(const Scene& scene) {
  if (scene.ocean.spectrum_data) return *scene.ocean.spectrum_data;
  require_file(scene, "ocean.spectrum_file", scene.ocean.spectrum_file, "a wave spectrum file");
  std::vector<WaveSpectrum> records = read_spectra(scene.ocean.spectrum_file, scene.trust);
  const auto index = static_cast<std::size_t>(scene.ocean.record);
  if (index >= records.size()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a record within [0, {}], got {}", scene.ocean.spectrum_file,
                            records.size() - 1, scene.ocean.record),
                "`offing ocean spectrum FILE` lists the records");
  }
  return std::move(records[index]);
}

/// The waves longer than a third of the peak's carry most of a sea: of a Pierson-Moskowitz spectrum
/// exp(-1.25 / 9) = 87 %.
constexpr double peak_lengths_of_split = 1.0 / 3.0;

std::optional<ocean::GerstnerChoice> gerstner_choice(const Scene& scene, const ocean::SeaSpectrum& spectrum) {
  if (scene.ocean.gerstner_count == 0) {
    return std::nullopt;
  }
  const double peak_m =
      2.0 * std::numbers::pi / spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
  const double split_m = scene.ocean.gerstner_split_m.value_or(peak_lengths_of_split * peak_m);
  return ocean::GerstnerChoice{.split_radpm = ocean::split_at_wavelength_radpm(split_m),
                               .count = scene.ocean.gerstner_count,
                               .seed = scene.world.seed};
}

/// The wind at 10 m whose whitecaps a sea has: its own, else the one that raises such a sea.
double whitecap_wind_mps(const Scene& scene, const Sea& sea) {
  const ocean::SpectrumParameters& spectrum = scene.ocean.spectrum;
  if (!sea.measured && spectrum.model != ocean::SpectrumModel::swell) {
    return ocean::is_by_height(spectrum) ? sea.wind.wind_speed_mps
                                         : ocean::wind_at_10_m_mps(spectrum.model, sea.wind.wind_speed_mps);
  }
  if (scene.ocean.wind_speed_mps) return *scene.ocean.wind_speed_mps;
  return ocean::wind_of_spectrum_mps(sea.spectrum);
}

/// Unless the scene says how much, foam covers what whitecaps do.
void add_whitecaps(const Scene& scene, Sea& sea) {
  std::optional<double>& fraction = sea.parameters.foam.fraction;
  if (!fraction) fraction = ocean::whitecap_fraction(whitecap_wind_mps(scene, sea));
}

std::string choppiness_warning(const Scene& scene, const ocean::GerstnerSea& gerstner_waves) {
  const ocean::HorizontalScale horizontal = ocean::horizontal_scale(gerstner_waves);
  if (!horizontal.is_limited) return {};
  const char* waves = scene.ocean.swells.empty()        ? "Gerstner waves"
                      : scene.ocean.gerstner_count != 0 ? "Gerstner waves and swells"
                                                        : "swells";
  return fmt::format(
      "the {} have a choppiness of {:.3g} instead of {:g}: they are so steep together that their crests "
      "would "
      "fold over. Lower or longer waves keep it",
      waves, horizontal.scale, gerstner_waves.choppiness);
}

/// The steepest wave of deep water is 0.1412 of its length high, twice its amplitude (Michell 1893).
constexpr double breaking_amplitude = 0.5 * 0.1412;  // of the wavelength

/// Rings are drawn at any height, since they do not move sideways; so they do not fold, but look wrong.
std::string raindrop_warning(std::span<const ocean::Raindrop> drops) {
  const auto steepness = [](const ocean::Raindrop& drop) {
    return std::abs(drop.amplitude_m) / drop.wavelength_m;
  };
  std::size_t count = 0;
  const ocean::Raindrop* steepest = nullptr;
  for (const ocean::Raindrop& drop : drops) {
    if (steepness(drop) <= breaking_amplitude) continue;
    ++count;
    if (steepest == nullptr || steepness(drop) > steepness(*steepest)) steepest = &drop;
  }
  if (steepest == nullptr) return {};
  return fmt::format(
      "{} of {} raindrops start steeper than real waves can be: a ring of wavelength_m = {:g} has "
      "amplitude_m = {:g}, and such waves break at {:.3g}",
      count, drops.size(), steepest->wavelength_m, steepest->amplitude_m,
      breaking_amplitude * steepest->wavelength_m);
}

void log_warnings(const Scene& scene, const Sea& sea) {
  for (const std::string& line :
       {steepness_warning(scene, sea.parameters.gerstner_waves), height_warning(scene, sea)}) {
    if (!line.empty()) spdlog::warn("{}", line);
  }
  for (const std::string& line : unused_parameters(scene, sea)) {
    spdlog::warn("{}", line);
  }
}

/// An irregular swell: as narrow in frequency as swells from far are, a Gaussian 6 % of its peak wide.
ocean::SeaSpectrum spectrum_of(const SwellScene& swell, const ocean::Dispersion& dispersion) {
  constexpr double usual_period_s = 12.0, relative_width = 0.06;
  ocean::SpectrumParameters parameters;
  parameters.model = ocean::SpectrumModel::swell;
  parameters.dispersion = dispersion;
  parameters.swell_hs_m = *swell.hs_m;
  parameters.swell_period_s = swell.tp_s.value_or(usual_period_s);
  parameters.swell_bandwidth_hz = relative_width / parameters.swell_period_s;
  parameters.swell_exponent_s = ocean::exponent_of_spread(swell.spread_rad);
  parameters.spreading.direction_rad = swell.direction_rad;
  return ocean::make_sea_spectrum(parameters);
}

/// Adds the irregular swells of a scene.
void add_swells(const Scene& scene, Sea& sea) {
  std::vector<ocean::SeaSpectrum> seas{std::move(sea.spectrum)};
  for (const SwellScene& swell : scene.ocean.swells) {
    if (swell.hs_m) seas.push_back(spectrum_of(swell, seas.front().dispersion));
  }
  sea.irregular_swells = seas.size() - 1;
  sea.spectrum = ocean::sum_of(std::move(seas));
}

}  // namespace

std::string height_warning(const Scene& scene, const Sea& sea) {
  const bool is_asked =
      sea.irregular_swells > 0 || (!sea.measured && scene.ocean.spectrum.hs_m &&
                                   scene.ocean.spectrum.model != ocean::SpectrumModel::phillips);
  if (!is_asked) return {};
  const double share = ocean::share_in_cascades(sea.spectrum, sea.parameters.cascades);
  constexpr double least = 0.98;  // of the energy: 1 % of the height
  if (share >= least) return {};
  return fmt::format(
      "the maps hold {:.1f} % of the waves' energy, {:.1f} % of their height; a larger --size or more "
      "cascades "
      "hold more",
      100.0 * share, 100.0 * std::sqrt(share));
}

void require_file(const Scene& scene, const char* key, const std::string& file, const char* kind) {
  const auto place = scene.set_at.find(key);
  if (place == scene.set_at.end() || is_there(file)) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected {}, got no such file, {}", place->second, kind, file),
              "check the path; in a scene it is relative to the scene file");
}

std::string steepness_warning(const Scene& scene, const ocean::GerstnerSea& gerstner_waves) {
  const std::string waves = choppiness_warning(scene, gerstner_waves);
  const std::string rings = raindrop_warning(gerstner_waves.raindrops);
  return waves.empty() || rings.empty() ? waves + rings : waves + "; " + rings;
}

std::vector<ocean::GerstnerWave> swells_of(const Scene& scene, const ocean::Dispersion& dispersion) {
  std::vector<ocean::GerstnerWave> waves;
  for (const SwellScene& asked : scene.ocean.swells) {
    if (asked.hs_m) continue;
    ocean::Swell swell{
        .amplitude_m = asked.amplitude_m, .direction_rad = asked.direction_rad, .phase_rad = asked.phase_rad};
    if (asked.wavelength_m) {
      swell.wavelength_m = *asked.wavelength_m;
    } else if (asked.period_s) {
      const double omega_radps = 2.0 * std::numbers::pi / *asked.period_s;
      swell.wavelength_m = 2.0 * std::numbers::pi / dispersion.wavenumber_radpm(omega_radps);
    }
    waves.push_back(ocean::make_swell(swell, dispersion));
  }
  return waves;
}

ocean::GerstnerSea gerstner_waves_of(const Sea& sea, std::uint64_t seed) {
  ocean::GerstnerSea gerstner_waves{.choppiness = sea.parameters.choppiness,
                                    .loop_period_s = sea.parameters.loop_period_s,
                                    .dispersion = sea.spectrum.dispersion};
  if (sea.gerstner_choice) {
    ocean::GerstnerChoice choice = *sea.gerstner_choice;
    choice.seed = seed;
    gerstner_waves.waves = ocean::choose_gerstner_waves(sea.spectrum, choice);
  }
  gerstner_waves.waves.insert(gerstner_waves.waves.end(), sea.swells.begin(), sea.swells.end());
  gerstner_waves.raindrops = sea.raindrops;
  return gerstner_waves;
}

ocean::Wind wind_of_sea(const Scene& scene) {
  return {.wind_speed_mps = scene.ocean.wind_speed_mps.value_or(scene.wind.wind_speed_mps),
          .wind_direction_rad = scene.ocean.wind_direction_rad.value_or(scene.wind.wind_direction_rad)};
}

namespace {

/// The sea of a spectrum, modelled or measured, without what prepare_sea() adds to all seas.
Sea sea_of_spectrum(const Scene& scene) {
  Sea sea;
  const ocean::Wind wind = wind_of_sea(scene);
  ocean::SpectrumParameters spectrum = scene.ocean.spectrum;
  spectrum.wind_speed_mps = wind.wind_speed_mps;
  spectrum.spreading.direction_rad = wind.wind_direction_rad;
  if (scene.ocean.depth_m) {
    spectrum.dispersion.depth_m = *scene.ocean.depth_m;
  }
  sea.wind = wind;
  if (scene.ocean.spectrum_file.empty()) {
    const bool is_by_height = ocean::is_by_height(spectrum);
    if (is_by_height) spectrum.spreading.wind_speed_mps = scene.ocean.wind_speed_mps;
    sea.spectrum = ocean::make_sea_spectrum(spectrum);
    if (is_by_height && !scene.ocean.wind_speed_mps) {
      sea.wind.wind_speed_mps = ocean::wind_of_height_and_period_mps(
          *spectrum.hs_m, 2.0 * std::numbers::pi / sea.spectrum.omega_peak_radps,
          spectrum.dispersion.gravity_mps2);
    }
  } else {
    sea.measured = read_record(scene);
    if (!scene.ocean.depth_m && sea.measured->depth_m) {
      spectrum.dispersion.depth_m = *sea.measured->depth_m;
    }
    if (scene.ocean.tail_hz) {
      sea.measured = with_tail(std::move(*sea.measured), *scene.ocean.tail_hz);
    }
    // Only a wind that was asked for: the default would be a guess, where the record's own peak tells the
    // wave age.
    spectrum.spreading.wind_speed_mps = scene.ocean.wind_speed_mps;
    sea.spectrum = ocean::from_measured(*sea.measured, spectrum.spreading, spectrum.dispersion);
  }

  add_swells(scene, sea);

  sea.parameters = scene.ocean.parameters;
  sea.parameters.loop_period_s = scene.time.loop_period_s;
  sea.gerstner_choice = gerstner_choice(scene, sea.spectrum);
  const double split_radpm = sea.gerstner_choice ? sea.gerstner_choice->split_radpm : 0.0;
  sea.parameters.cascades = scene.ocean.patch_lengths_m.empty()
                                ? ocean::choose_cascades(sea.spectrum, scene.ocean.parameters.size,
                                                         scene.ocean.cascade_count, split_radpm)
                                : ocean::cascades_from_patches(scene.ocean.patch_lengths_m,
                                                               scene.ocean.parameters.size, split_radpm);
  return sea;
}

}  // namespace

Sea prepare_sea(const Scene& scene, Warnings warnings) {
  if (!scene.has_sea()) {
    throw Error(ErrorKind::bad_input, "scene: expected a sea, found none",
                "add an [ocean] section to the scene");
  }
  Sea sea = scene.ocean.modes_file.empty() ? sea_of_spectrum(scene) : sea_of_modes(scene);
  sea.parameters.seed = scene.world.seed;
  add_whitecaps(scene, sea);
  const std::vector<ocean::GerstnerWave> swells = swells_of(scene, sea.spectrum.dispersion);
  sea.swells.insert(sea.swells.begin(), swells.begin(), swells.end());
  sea.raindrops = scene.ocean.raindrops;
  sea.parameters.gerstner_waves = gerstner_waves_of(sea, sea.parameters.seed);
  if (warnings == Warnings::logged) log_warnings(scene, sea);
  return sea;
}

namespace {

std::string name_without_swells(const Scene& scene, const Sea& sea) {
  if (!sea.measured) {
    const std::string model = value_text(scene, *find_parameter("ocean.spectrum"));
    if (!ocean::is_by_height(scene.ocean.spectrum)) {
      return fmt::format("{}, wind {:g} m/s", model, wind_of_sea(scene).wind_speed_mps);
    }
    const ocean::SpectrumParameters& asked = scene.ocean.spectrum;
    const std::string period = asked.tz_s   ? fmt::format(", Tz {:g} s", *asked.tz_s)
                               : asked.tp_s ? fmt::format(", Tp {:g} s", *asked.tp_s)
                                            : "";
    return fmt::format("{}, Hs {:g} m{}", model, *asked.hs_m, period);
  }
  std::string name = "measured";
  for (const std::string* part : {&sea.measured->station, &sea.measured->time_utc}) {
    name += part->empty() ? "" : ", " + *part;
  }
  return name;
}

}  // namespace

std::string spectrum_name(const Scene& scene, const Sea& sea) {
  const std::string name = name_without_swells(scene, sea);
  if (sea.irregular_swells == 0) return name;
  return fmt::format("{}, {} swell{}", name, sea.irregular_swells, sea.irregular_swells == 1 ? "" : "s");
}

}  // namespace offing::scene
