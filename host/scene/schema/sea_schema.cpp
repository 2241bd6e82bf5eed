// [wind] and [ocean]: the sea.
#include <algorithm>
#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include "host/base/parameter_check.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using ocean::FoamParameters;
using ocean::OceanParameters;
using ocean::SpectrumModel;
using ocean::SpectrumParameters;
using ocean::SpreadingModel;

// What the shaders of the water take (present/passes/water/wakes.glsl).
constexpr std::size_t max_wakes = 4;
// Of the 128 Gerstner waves that a sea can have, 64 are for the spectrum's long waves.
constexpr std::size_t max_swells = 64;
constexpr std::size_t max_raindrops = 4096;

/// What shapes the energy of the sea, and with it each baked frame.
constexpr Affects sea = Affects::spectrum | Affects::baked;

/// Of SpectrumModel and SpreadingModel.
constexpr std::array<std::string_view, 5> spectrum_names{"phillips", "pm", "jonswap", "tma", "swell"};
constexpr std::array<std::string_view, 5> spreading_names{"cosine", "mitsuyasu", "hasselmann",
                                                          "donelan-banner", "phillips"};

std::string spectrum_is(const OceanSection& ocean) {
  return fmt::format("the spectrum is {}", spectrum_names[static_cast<std::size_t>(ocean.spectrum.model)]);
}

std::string spreading_is(const OceanSection& ocean) {
  return fmt::format("the spreading is {}",
                     spreading_names[static_cast<std::size_t>(ocean.spectrum.spreading.model)]);
}

const std::string& file_of_sea(const OceanSection& ocean) {
  return ocean.modes_file.empty() ? ocean.spectrum_file : ocean.modes_file;
}

std::string needs_model(const UseContext& context, const OceanSection& ocean) {
  return context.sea.is_measured ? "the sea comes from " + file_of_sea(ocean) : "";
}

/// A file of modes has the lattice of its waves, and how they move.
template <class Struct>
std::string needs_random_waves(const UseContext& context, const Struct&) {
  const std::string& file = context.scene.ocean.modes_file;
  return file.empty() ? "" : "the waves come from " + file;
}

std::string needs_record(const UseContext& context, const OceanSection& ocean) {
  return context.sea.is_measured && ocean.modes_file.empty() ? "" : "there is no measured spectrum";
}

/// A record that ends below the tail.
std::string needs_short_record(const UseContext& context, const OceanSection& ocean) {
  // With its tail, the record ends there.
  const bool is_needless =
      context.sea.is_measured && ocean.tail_hz && context.sea.last_hz > *ocean.tail_hz * (1.0 + 1e-9);
  return is_needless ? fmt::format("{} reaches {:g} Hz by itself", ocean.spectrum_file, context.sea.last_hz)
                     : needs_record(context, ocean);
}

std::string needs_one_of(std::initializer_list<SpectrumModel> models, const UseContext& context,
                         const OceanSection& ocean) {
  if (context.sea.is_measured) return needs_model(context, ocean);
  return std::ranges::find(models, ocean.spectrum.model) == models.end() ? spectrum_is(ocean) : "";
}

std::string needs_jonswap_or_tma(const UseContext& context, const OceanSection& ocean) {
  return needs_one_of({SpectrumModel::jonswap, SpectrumModel::tma}, context, ocean);
}

std::string needs_fetch(const UseContext& context, const OceanSection& ocean) {
  const std::string reason = needs_jonswap_or_tma(context, ocean);
  return reason.empty() && ocean.spectrum.hs_m ? "ocean.hs_m replaces wind and fetch" : reason;
}

std::string needs_model_with_height(const UseContext& context, const OceanSection& ocean) {
  return needs_one_of(
      {SpectrumModel::pierson_moskowitz, SpectrumModel::jonswap, SpectrumModel::tma, SpectrumModel::swell},
      context, ocean);
}

/// A wind sea by height and period.
std::string needs_height(const UseContext& context, const OceanSection& ocean) {
  const std::string reason = needs_one_of(
      {SpectrumModel::pierson_moskowitz, SpectrumModel::jonswap, SpectrumModel::tma}, context, ocean);
  return reason.empty() && !ocean.spectrum.hs_m ? "there is no hs_m" : reason;
}

std::string needs_peak_period(const UseContext& context, const OceanSection& ocean) {
  if (context.sea.is_measured || ocean.spectrum.model != SpectrumModel::swell) {
    const std::string reason = needs_height(context, ocean);
    return reason.empty() && ocean.spectrum.tz_s ? "ocean.tz_s sets the period" : reason;
  }
  return "";
}

std::string needs_shallow_tma(const UseContext& context, const OceanSection& ocean) {
  const bool is_deep_tma =
      !context.sea.is_measured && ocean.spectrum.model == SpectrumModel::tma && context.sea.is_deep;
  return is_deep_tma ? "the water is deep" : needs_one_of({SpectrumModel::tma}, context, ocean);
}

std::string needs_phillips(const UseContext& context, const OceanSection& ocean) {
  return needs_one_of({SpectrumModel::phillips}, context, ocean);
}

std::string needs_swell(const UseContext& context, const OceanSection& ocean) {
  return needs_one_of({SpectrumModel::swell}, context, ocean);
}

std::string needs_swell_height(const UseContext& context, const OceanSection& ocean) {
  const std::string reason = needs_swell(context, ocean);
  return reason.empty() && ocean.spectrum.hs_m ? "ocean.hs_m sets the height" : reason;
}

std::string needs_swell_period(const UseContext& context, const OceanSection& ocean) {
  const std::string reason = needs_swell(context, ocean);
  return reason.empty() && ocean.spectrum.tp_s ? "ocean.tp_s sets the period" : reason;
}

/// Waves that run as the wind does, whatever section says where.
template <class Struct>
std::string needs_wind_direction(const UseContext& context, const Struct&) {
  return context.sea.is_directional ? file_of_sea(context.scene.ocean) + " has directions of its own" : "";
}

std::string needs_spreading(const UseContext& context, const OceanSection& ocean) {
  const SpectrumModel model = ocean.spectrum.model;
  const bool is_fixed = model == SpectrumModel::phillips || model == SpectrumModel::swell;
  return !context.sea.is_measured && is_fixed ? spectrum_is(ocean) + ", which has a spreading of its own"
                                              : needs_wind_direction(context, ocean);
}

std::string needs_cosine(const UseContext& context, const OceanSection& ocean) {
  const std::string reason = needs_spreading(context, ocean);
  const bool is_cosine = ocean.spectrum.spreading.model == SpreadingModel::cosine_2s;
  return reason.empty() && !is_cosine ? spreading_is(ocean) : reason;
}

/// A sea that wind makes, or one whose spreading has a wave age.
std::string needs_wind_of_waves(const UseContext& context, const OceanSection& ocean) {
  if (!context.sea.is_measured) {
    return ocean.spectrum.model == SpectrumModel::swell ? spectrum_is(ocean) : "";
  }
  const SpreadingModel model = ocean.spectrum.spreading.model;
  const bool has_wave_age = model == SpreadingModel::mitsuyasu || model == SpreadingModel::hasselmann;
  const std::string reason = needs_wind_direction(context, ocean);
  return reason.empty() && !has_wave_age ? spreading_is(ocean) : reason;
}

/// The wind also makes the whitecaps, unless the scene says how much foam there is.
std::string needs_own_wind(const UseContext& context, const OceanSection& ocean) {
  const FoamParameters& foam = ocean.parameters.foam;
  return foam.fraction || foam.onset_jacobian ? needs_wind_of_waves(context, ocean) : "";
}

std::string needs_wind(const UseContext& context, const ocean::Wind&) {
  if (context.sea.is_measured) return "a measured sea uses only its own wind, ocean.wind_speed_mps";
  return is_by_height(context.scene.ocean.spectrum)
             ? "a sea by height and period uses only its own wind, ocean.wind_speed_mps"
             : needs_wind_of_waves(context, context.scene.ocean);
}

std::string needs_no_onset(const UseContext&, const FoamParameters& foam) {
  return foam.onset_jacobian ? "ocean.foam.onset_jacobian is set" : "";
}

std::string needs_ground(const UseContext& context, const OceanSection&) {
  return context.scene.terrain.is_given ? "" : "the scene has no terrain";
}

std::string needs_chosen_cascades(const UseContext&, const OceanSection& ocean) {
  return ocean.patch_lengths_m.empty() ? "" : "the patches are given";
}

std::string needs_gerstner_waves(const UseContext&, const OceanSection& ocean) {
  return ocean.gerstner_count > 0 ? "" : "there are no Gerstner waves";
}

std::vector<Row<OceanSection>> energy_rows() {
  using ocean::Dispersion;
  using ocean::SpreadingParameters;
  constexpr auto spectrum = &OceanSection::spectrum;
  constexpr auto spreading = &SpectrumParameters::spreading;
  constexpr auto dispersion = &SpectrumParameters::dispersion;
  return {
      {choice(path(spectrum, &SpectrumParameters::model), {spectrum_names.begin(), spectrum_names.end()}),
       {.key = "spectrum",
        .flag = "--spectrum",
        .help = "model of the wave spectrum; a measured spectrum file replaces it. Other values name in "
                "parentheses the models that use them"},
       needs_model},
      {&OceanSection::wind_speed_mps,
       {.key = "wind_speed_mps",
        .affects = Affects::spectrum,
        .flag = "--wind-speed-mps",
        .unit = "m/s",
        .low = 0.1,
        .high = 60.0,
        .help =
            "wind speed at 10 m above the sea (pm: at 19.5 m). With hs_m or a measured sea it affects only "
            "spreading and whitecaps",
        .example = "10",
        .absent = "as in [wind]: 10; with hs_m or a measured sea, computed from height and period"},
       needs_own_wind},
      {&OceanSection::wind_direction_rad,
       {.key = "wind_direction_deg",
        .affects = Affects::spectrum,
        .flag = "--wind-direction-deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "direction in which the wind blows, from +x (east) toward +z (south)",
        .example = "30",
        .absent = "as in [wind]: 0",
        .scale = radians_per_degree},
       needs_wind_direction},
      {path(spectrum, &SpectrumParameters::fetch_m),
       {.key = "fetch_m",
        .flag = "--fetch-m",
        .unit = "m",
        .low = 100.0,
        .high = 1e7,
        .help = "fetch: distance over water that the wind has blown (jonswap, tma)",
        .instead_of = "hs_m"},
       needs_fetch},
      {path(spectrum, &SpectrumParameters::hs_m),
       {.key = "hs_m",
        .flag = "--hs-m",
        .unit = "m",
        .low = 0.001,
        .high = 30.0,
        .help = "significant wave height 4 sqrt(m0), in place of wind and fetch (jonswap, tma, pm, swell)",
        .example = "2.5",
        .absent = "from wind and fetch"},
       needs_model_with_height},
      {path(spectrum, &SpectrumParameters::tp_s),
       {.key = "tp_s",
        .flag = "--tp-s",
        .unit = "s",
        .low = 0.5,
        .high = 40.0,
        .help = "peak period: 1 / f where the energy density E(f) is largest; needs hs_m, except for swell",
        .example = "8",
        .absent = "that of a fully developed sea: 5 sqrt(hs_m)",
        .instead_of = "tz_s"},
       needs_peak_period},
      {path(spectrum, &SpectrumParameters::tz_s),
       {.key = "tz_s",
        .flag = "--tz-s",
        .unit = "s",
        .low = 0.4,
        .high = 40.0,
        .help = "mean zero-crossing period Tm02 = sqrt(m0 / m2), in place of tp_s (jonswap, tma, pm)",
        .example = "6",
        .absent = "from tp_s"},
       needs_height},
      {&OceanSection::depth_m,
       {.key = "depth_m",
        .flag = "--depth-m",
        .unit = "m",
        .low = 0.1,
        .high = deepest_m,
        .help = "water depth",
        .example = "50",
        .absent = "deep water, or the depth in the measured file"}},
      {choice(&OceanSection::water, {"I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C"}),
       {.key = "water",
        .affects = Affects::water | Affects::baked,
        .flag = "--water",
        .help = "Jerlov water type, from clear blue ocean (I) to brown coast (9C); sets how far the bed "
                "shows through"}},
      {choice(&OceanSection::shoaling, {"off", "on"}),
       {.key = "shoals",
        .help = "whether waves feel the bed and break on shores; turn off for a map without depths, whose "
                "sea is terrain at 0 m"},
       needs_ground},
      {choice(path(spectrum, &SpectrumParameters::depth_factor), {"thompson-vincent", "kitaigorodskii"}),
       {.key = "depth_factor",
        .flag = "--depth-factor",
        .help = "how tma weakens waves in shallow water: by the usual approximation or the exact ratio"},
       needs_shallow_tma},
      {path(spectrum, &SpectrumParameters::gamma),
       {.key = "gamma",
        .flag = "--gamma",
        .low = 1.0,
        .high = 20.0,
        .help = "peak enhancement factor: how sharp the peak is (jonswap, tma)"},
       needs_jonswap_or_tma},
      {path(spectrum, &SpectrumParameters::phillips_constant),
       {.key = "phillips_constant",
        .flag = "--phillips-constant",
        .low = 1e-12,
        .high = 1.0,
        .help = "constant A of the Phillips spectrum, which scales its energy (phillips)",
        .example = "0.00129",
        .absent = "0.0081 / (2 pi), for heights in metres"},
       needs_phillips},
      {path(spectrum, &SpectrumParameters::phillips_cutoff_m),
       {.key = "phillips_cutoff_m",
        .flag = "--phillips-cutoff-m",
        .unit = "m",
        .low = 0.0,
        .high = 100.0,
        .help = "damp waves shorter than this (phillips)"},
       needs_phillips},
      {path(spectrum, &SpectrumParameters::phillips_upwind),
       {.key = "phillips_upwind",
        .flag = "--phillips-upwind",
        .low = 0.0,
        .high = 1.0,
        .help = "factor on the energy of waves that travel against the wind (phillips)"},
       needs_phillips},
      {path(spectrum, &SpectrumParameters::swell_hs_m),
       {.key = "swell_hs_m",
        .flag = "--swell-hs-m",
        .unit = "m",
        .low = 0.001,
        .high = 30.0,
        .help = "significant wave height (swell)",
        .example = "1",
        .instead_of = "hs_m"},
       needs_swell_height},
      {path(spectrum, &SpectrumParameters::swell_period_s),
       {.key = "swell_period_s",
        .flag = "--swell-period-s",
        .unit = "s",
        .low = 1.0,
        .high = 40.0,
        .help = "peak period (swell)",
        .instead_of = "tp_s"},
       needs_swell_period},
      {path(spectrum, &SpectrumParameters::swell_bandwidth_hz),
       {.key = "swell_bandwidth_hz",
        .flag = "--swell-bandwidth-hz",
        .unit = "Hz",
        .low = 0.0001,
        .high = 0.1,
        .help = "width of the spectrum, as standard deviation of frequency (swell)"},
       needs_swell},
      {path(spectrum, &SpectrumParameters::swell_exponent_s),
       {.key = "swell_exponent",
        .flag = "--swell-exponent",
        .low = 0.0,
        .high = 1000.0,
        .help = "exponent s of the spreading cos^2s around the wind direction (swell)"},
       needs_swell},
      {choice(path(spectrum, spreading, &SpreadingParameters::model),
              {spreading_names.begin(), spreading_names.end()}),
       {.key = "spreading",
        .flag = "--spreading",
        .help = "how wave energy spreads around the wind direction; a measured file with directions keeps "
                "its own"},
       needs_spreading},
      {path(spectrum, spreading, &SpreadingParameters::exponent_s),
       {.key = "spreading_exponent",
        .flag = "--spreading-exponent",
        .low = 0.0,
        .high = 1000.0,
        .help = "exponent s of the spreading cos^2s (cosine)"},
       needs_cosine},
      {path(spectrum, spreading, &SpreadingParameters::swell),
       {.key = "spreading_swell",
        .flag = "--spreading-swell",
        .low = 0.0,
        .high = 1.0,
        .help = "how parallel the crests are: 0 as in a wind sea ... 1 long parallel crests"},
       needs_spreading},
      {path(spectrum, dispersion, &Dispersion::gravity_mps2),
       {.key = "gravity_mps2",
        .flag = "--gravity-mps2",
        .unit = "m/s^2",
        .low = 0.1,
        .high = 100.0,
        .help = "acceleration of gravity"}},
      {path(spectrum, dispersion, &Dispersion::capillary_length_m),
       {.key = "capillary_length_m",
        .flag = "--capillary-length-m",
        .unit = "m",
        .low = 0.0,
        .high = 0.01,
        .help = "capillary length: 0.00273 for clean sea water; 0 leaves out surface tension"}},
      {&OceanSection::modes_file,
       {.key = "modes_file",
        .affects = Affects::spectrum,
        .flag = "--modes-file",
        .help = "file of single waves, as `offing ocean modes` writes it: NetCDF or CSV. It replaces the "
                "spectrum and sets patches, size and choppiness",
        .example = "modes.nc",
        .absent = "waves are drawn from a spectrum",
        .rule = ParameterRule::file_name}},
      {&OceanSection::spectrum_file,
       {.key = "spectrum_file",
        .affects = Affects::spectrum,
        .flag = "--spectrum-file",
        .help =
            "file of a measured spectrum: NDBC, WAVEWATCH III, SWAN, Datawell, TRIAXYS, Octopus, Spotter or "
            "NetCDF",
        .example = "41010.data_spec",
        .absent = "none",
        .rule = ParameterRule::file_name},
       needs_random_waves<OceanSection>},
      {&OceanSection::record,
       {.key = "record",
        .affects = Affects::spectrum,
        .flag = "--record",
        .high = 1e9,
        .help = "record to use in the measured spectrum file, counted from 0"},
       needs_record},
      {&OceanSection::tail_hz,
       {.key = "tail_hz",
        .flag = "--tail-hz",
        .unit = "Hz",
        .low = 0.1,
        .high = 20.0,
        .help =
            "extend the measured spectrum as f^-5 up to this frequency, to add short waves that buoys miss",
        .example = "3",
        .absent = "no tail: only the energy in the file"},
       needs_short_record}};
}

std::vector<Row<OceanSection>> grid_rows() {
  constexpr auto parameters = &OceanSection::parameters;
  return {{path(parameters, &OceanParameters::size),
           {.key = "size",
            .flag = "--size",
            .low = 16.0,
            .high = 4096.0,
            .help = "samples along each side of a patch",
            .rule = ParameterRule::power_of_two},
           needs_random_waves<OceanSection>},
          {&OceanSection::cascade_count,
           {.key = "cascade_count",
            .affects = Affects::spectrum,
            .flag = "--cascades",
            .low = 1.0,
            .high = 4.0,
            .help = "largest number of cascades to choose when no patch is given"},
           needs_chosen_cascades}};
}

Schema<OceanSection> cascade_schema() {
  Schema<OceanSection> schema("cascade");
  return schema.rows(
      ParameterGroup::grid, Affects::spectrum,
      {{&OceanSection::patch_lengths_m,
        {.key = "patch_m",
         .flag = "--patch-m",
         .unit = "m",
         .low = 0.1,
         .high = 1e6,
         .help = "side of a cascade's square patch; for several cascades repeat it or separate by commas",
         .example = "250",
         .absent = "chosen from the spectrum",
         .max_count = 4},
        needs_random_waves<OceanSection>}});
}

Schema<OceanSection> gerstner_schema() {
  Schema<OceanSection> schema("gerstner");
  return schema.rows(ParameterGroup::grid, sea,
                     {{&OceanSection::gerstner_count,
                       {.key = "count",
                        .flag = "--gerstner-count",
                        .high = 64.0,
                        .help = "number of Gerstner waves for the longest waves of the spectrum; with 0 the "
                                "cascades make all waves"},
                       needs_random_waves<OceanSection>},
                      {&OceanSection::gerstner_split_m,
                       {.key = "split_wavelength_m",
                        .flag = "--gerstner-split-m",
                        .unit = "m",
                        .low = 0.1,
                        .high = 1e5,
                        .help = "make waves longer than this as Gerstner waves, shorter ones in the cascades",
                        .example = "50",
                        .absent = "a third of the peak wavelength"},
                       needs_gerstner_waves}});
}

Schema<FoamParameters> foam_schema() {
  Schema<FoamParameters> schema("foam");
  return schema.rows(ParameterGroup::foam, sea,
                     {{&FoamParameters::fraction,
                       {.key = "fraction",
                        .flag = "--foam-fraction",
                        .high = ocean::most_foam,
                        .help = "share of the sea that foam covers on average",
                        .example = "0.05",
                        .absent = "as much as whitecaps in this wind"},
                       needs_no_onset},
                      {&FoamParameters::onset_jacobian,
                       {.key = "onset_jacobian",
                        .flag = "--foam-onset",
                        .low = -10.0,
                        .high = 1.0,
                        .help = "onset: Jacobian below which foam forms",
                        .example = "0.7",
                        .absent = "computed from the spectrum, for the foam fraction"}},
                      {&FoamParameters::width,
                       {.key = "width",
                        .flag = "--foam-width",
                        .low = 0.001,
                        .high = 10.0,
                        .help = "how far the Jacobian must fall below the onset for foam to cover everything",
                        .example = "0.1",
                        .absent = "computed from the spectrum"}},
                      {&FoamParameters::min_wavelength_m,
                       {.key = "min_wavelength_m",
                        .flag = "--foam-min-wavelength-m",
                        .unit = "m",
                        .high = 1e4,
                        .help = "waves shorter than this make no foam"}},
                      {&FoamParameters::decay_s,
                       {.key = "decay_s",
                        .flag = "--foam-decay-s",
                        .unit = "s",
                        .low = 0.01,
                        .high = 100.0,
                        .help = "time in which foam fades to 1/e"}},
                      {&FoamParameters::step_s,
                       {.key = "step_s",
                        .flag = "--foam-step-s",
                        .unit = "s",
                        .low = 0.01,
                        .high = 10.0,
                        .help = "foam is computed from past states of the sea, which are this far apart"}}});
}

}  // namespace

Schema<ocean::Wind> wind_schema() {
  Schema<ocean::Wind> schema("wind");
  return schema.rows(ParameterGroup::wind, sea,
                     {{&ocean::Wind::wind_speed_mps,
                       {.key = "speed_mps",
                        .unit = "m/s",
                        .low = 0.1,
                        .high = 60.0,
                        .help = "wind speed for everything that the wind moves"},
                       needs_wind},
                      {&ocean::Wind::wind_direction_rad,
                       {.key = "direction_deg",
                        .unit = "deg",
                        .low = -360.0,
                        .high = 360.0,
                        .help = "direction in which the wind blows, from +x (east) toward +z (south)",
                        .scale = radians_per_degree},
                       needs_wind_direction}});
}

Schema<OceanSection> ocean_schema() {
  constexpr auto parameters = &OceanSection::parameters;
  Schema<OceanSection> schema("ocean");
  return schema.rows(ParameterGroup::sea, sea, energy_rows())
      .rows(ParameterGroup::grid, sea, grid_rows())
      .section(cascade_schema())
      .section(gerstner_schema())
      .rows(ParameterGroup::grid, sea,
            {{path(parameters, &OceanParameters::choppiness),
              {.key = "choppiness",
               .flag = "--choppiness",
               .low = 0.0,
               .high = 5.0,
               .help = "factor on horizontal displacement: 0 none, 1 as in linear theory; larger sharpens "
                       "the crests"},
              needs_random_waves<OceanSection>}})
      .section(path(parameters, &OceanParameters::foam), foam_schema())
      .list(&OceanSection::swells, max_swells, swell_schema())
      .list(&OceanSection::raindrops, max_raindrops, raindrop_schema())
      .list(&OceanSection::wakes, max_wakes, wake_schema());
}

}  // namespace offing::scene
