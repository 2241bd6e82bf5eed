#include "host/io/spectra/netcdf_spectra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/netcdf_file.h"
#include "host/io/spectra/netcdf_units.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

// All spectra together: a gibibyte of doubles.
constexpr std::size_t most_values_in_all = std::size_t{1} << 27;

/// Reads one file: holds what all its spectra share.
class SpectraFile {
 public:
  SpectraFile(std::span<const std::byte> bytes, std::string_view file_name);

  std::vector<WaveSpectrum> read_all();

 private:
  NetcdfVariable need_density() const;
  std::string unit_of(const NetcdfVariable& variable) const;
  std::vector<double> need_frequencies() const;
  std::optional<DirectionGrid> directions() const;
  double (*direction_convention(const NetcdfVariable& variable) const)(double);
  void warn_of_unread_directions() const;
  std::optional<TimeUnit> time_unit() const;
  std::vector<double> times() const;

  /// The value of `variable`, whose dimensions are among the density's, at the present place; NaN if there is
  /// none.
  double value_here(const std::optional<NetcdfVariable>& variable) const;
  std::string station_here() const;
  std::string time_here() const;
  std::optional<WaveSpectrum> spectrum_here() const;

  /// Moves to the next place; false after the last.
  bool next_place();

  std::string place_name() const { return fmt::format("{}: {}", file_.name(), density_.name); }

  NetcdfFile file_;
  NetcdfVariable density_;
  std::optional<std::size_t> frequency_axis_;
  std::optional<std::size_t> direction_axis_;
  std::vector<double> frequencies_hz_;
  std::optional<DirectionGrid> directions_;
  double unit_ = 1.0;
  std::optional<NetcdfVariable> scale_;
  std::optional<NetcdfVariable> latitude_;
  std::optional<NetcdfVariable> longitude_;
  std::optional<NetcdfVariable> depth_;
  std::optional<NetcdfVariable> station_name_;
  std::optional<TimeUnit> time_unit_;
  std::vector<double> times_;
  std::vector<std::size_t> start_;  ///< the present place, 0 along frequency and direction
  std::vector<std::size_t> count_;  ///< 1, but the whole of frequency and direction
};

SpectraFile::SpectraFile(std::span<const std::byte> bytes, std::string_view file_name)
    : file_(bytes, file_name),
      density_(need_density()),
      frequency_axis_(density_.axis({"frequency", "freq"})),
      direction_axis_(density_.axis({"direction", "dir"})),
      frequencies_hz_(need_frequencies()),
      directions_(directions()),
      scale_(file_.find({"scale_" + density_.name})),
      latitude_(file_.find({"latitude", "lat"})),
      longitude_(file_.find({"longitude", "lon"})),
      depth_(file_.find({"dpt", "depth"})),
      station_name_(file_.find({"station_name"})),
      time_unit_(time_unit()),
      times_(times()),
      start_(density_.lengths.size(), 0),
      count_(density_.lengths.size(), 1) {
  const std::string unit_text = unit_of(density_);
  const std::optional<DensityUnit> unit = parse_density_unit(unit_text);
  if (!unit || unit->is_directional != directions_.has_value()) {
    file_.fail(fmt::format("{}: expected units of {}, got \"{}\"", density_.name,
                           directions_ ? "m2 s rad-1" : "m2 s", printable(unit_text)),
               "set the variable's units attribute (ncatted)");
  }
  unit_ = unit->in_si;
  if (!directions_) warn_of_unread_directions();
  count_[*frequency_axis_] = density_.lengths[*frequency_axis_];
  if (direction_axis_) count_[*direction_axis_] = density_.lengths[*direction_axis_];

  // With resampled directions a spectrum can be larger than its values in the file.
  const double widening = directions_ ? static_cast<double>(directions_->directions_rad().size()) /
                                            static_cast<double>(density_.lengths[*direction_axis_])
                                      : 1.0;
  double total = std::max(1.0, widening);
  for (const std::size_t length : density_.lengths) total *= static_cast<double>(length);
  if (total > static_cast<double>(most_values_in_all)) {
    file_.fail(
        fmt::format("{}: expected at most {} values, got {:.0f}", density_.name, most_values_in_all, total),
        "extract fewer times or points first (ncks -d time,0,99)");
  }
}

NetcdfVariable SpectraFile::need_density() const {
  std::optional<NetcdfVariable> density =
      file_.find({"efth", "density", "energy", "VaDens", "energy_1d", "ef"});
  if (!density) {
    file_.fail("expected a variable efth, density, energy or energy_1d, got none of them",
               "give a file of spectra by WAVEWATCH III (ww3_ounp), SWAN or wavespectra");
  }
  return *density;
}

/// wavespectra (4.9) names its axes freq and dir, and mostly leaves out their units, which it fixes: Hz,
/// degrees that waves come from, m^2/Hz/degree.
std::string SpectraFile::unit_of(const NetcdfVariable& variable) const {
  const std::string unit = file_.text_attribute(variable, "units");
  if (!unit.empty() || !density_.axis({"freq"})) return unit;
  if (variable.name == "freq") return "Hz";
  if (variable.name == "dir") return "degree";
  return density_.axis({"dir"}) ? "m2 s degree-1" : "m2 s";
}

std::vector<double> SpectraFile::need_frequencies() const {
  const auto variable = file_.find({"frequency", "freq"});
  if (!frequency_axis_ || !variable) {
    file_.fail(fmt::format("{}: expected a dimension and a variable frequency, got none", density_.name),
               "give a file of spectra by WAVEWATCH III (ww3_ounp), SWAN or wavespectra");
  }
  const std::string unit_text = unit_of(*variable);
  const std::optional<double> unit_hz = parse_frequency_unit(unit_text);
  if (!unit_hz) {
    file_.fail(fmt::format("{}: expected units of s-1, got \"{}\"", variable->name, printable(unit_text)),
               "set the variable's units attribute (ncatted)");
  }
  std::vector<double> frequencies_hz = file_.column(*variable);
  for (double& f_hz : frequencies_hz) f_hz *= *unit_hz;
  if (frequencies_hz.size() != density_.lengths[*frequency_axis_]) {
    file_.fail(fmt::format("{}: expected {} values, got {}", variable->name,
                           density_.lengths[*frequency_axis_], frequencies_hz.size()),
               "give the variable of frequencies the dimension of the density");
  }
  check_frequencies(frequencies_hz, fmt::format("{}: {}", file_.name(), variable->name));
  return frequencies_hz;
}

double (*SpectraFile::direction_convention(const NetcdfVariable& variable) const)(double) {
  const std::string standard_name = file_.text_attribute(variable, "standard_name");
  const bool is_cartesian = file_.global_attribute("Directional_convention") == "cartesian";
  const bool is_wavespectra = standard_name.empty() && variable.name == "dir";
  if (is_wavespectra || standard_name.ends_with("from_direction")) return direction_from_origin_bearing;
  // ww3_ounp has always written directions of travel, early versions without saying so.
  const bool is_travel =
      standard_name.ends_with("to_direction") || (standard_name.empty() && density_.name == "efth");
  if (!is_travel) {
    file_.fail(
        fmt::format("{}: expected a standard_name ending in from_direction or to_direction, got \"{}\"",
                    variable.name, printable(standard_name)),
        "set the variable's standard_name attribute to sea_surface_wave_from_direction or ..._to_direction");
  }
  return is_cartesian ? direction_from_cartesian : direction_from_travel_bearing;
}

std::optional<DirectionGrid> SpectraFile::directions() const {
  if (!direction_axis_) return std::nullopt;
  const auto variable = file_.find({"direction", "dir"});
  const std::string unit_text = variable ? unit_of(*variable) : "";
  const std::optional<double> unit_rad = parse_direction_unit(unit_text);
  if (!variable || !unit_rad) {
    file_.fail(fmt::format("expected a variable direction in degrees or radians, got units \"{}\"",
                           printable(unit_text)),
               "set the variable's units attribute (ncatted)");
  }
  const auto direction_of_travel = direction_convention(*variable);
  std::vector<double> angles_rad = file_.column(*variable);
  for (double& angle : angles_rad) angle = direction_of_travel(angle * *unit_rad);
  if (angles_rad.size() != density_.lengths[*direction_axis_]) {
    file_.fail(fmt::format("{}: expected {} values, got {}", variable->name,
                           density_.lengths[*direction_axis_], angles_rad.size()),
               "give the variable of directions the dimension of the density");
  }
  return DirectionGrid(std::move(angles_rad), fmt::format("{}: {}", file_.name(), variable->name));
}

/// SWAN gives theta_1d without saying whether waves come from there, and spread_1d in degrees but described
/// as an exponent: a guess could turn the sea around.
void SpectraFile::warn_of_unread_directions() const {
  if (!file_.find({"theta_1d", "spread_1d"})) return;
  spdlog::warn(
      "{}: theta_1d and spread_1d do not state their conventions and are not read: spectra without "
      "directions "
      "(have SWAN write SPEC2D, or SPEC1D as text)",
      file_.name());
}

std::optional<TimeUnit> SpectraFile::time_unit() const {
  const auto variable = file_.find({"time"});
  if (!variable || !density_.axis({"time"})) return std::nullopt;
  const std::string calendar = file_.text_attribute(*variable, "calendar");
  const bool is_civil = calendar.empty() || calendar == "gregorian" || calendar == "standard" ||
                        calendar == "proleptic_gregorian";
  const std::string unit_text = file_.text_attribute(*variable, "units");
  const std::optional<TimeUnit> unit = parse_time_unit(unit_text);
  if (!unit || !is_civil) {
    file_.fail(fmt::format(
                   "time: expected units such as \"days since 1990-01-01\" in the civil calendar, got \"{}\" "
                   "in \"{}\"",
                   printable(unit_text), printable(calendar)),
               "set the variable's units and calendar attributes (ncatted)");
  }
  return unit;
}

std::vector<double> SpectraFile::times() const {
  return time_unit_ ? file_.column(*file_.find({"time"})) : std::vector<double>();
}

double SpectraFile::value_here(const std::optional<NetcdfVariable>& variable) const {
  if (!variable) return std::numeric_limits<double>::quiet_NaN();
  std::vector<std::size_t> start;
  for (std::size_t i = 0; i < variable->dimensions.size(); ++i) {
    const auto found = density_.axis({variable->dimensions[i]});
    if (!found || count_[*found] != 1 || start_[*found] >= variable->lengths[i]) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    start.push_back(start_[*found]);
  }
  const std::vector<std::size_t> one(start.size(), 1);
  return file_.values(*variable, start, one).front();
}

std::string SpectraFile::station_here() const {
  if (station_name_ && station_name_->dimensions.size() == 2) {
    const auto station_axis = density_.axis({station_name_->dimensions[0]});
    if (station_axis && start_[*station_axis] < station_name_->lengths[0]) {
      const std::size_t start[2] = {start_[*station_axis], 0};
      const std::size_t count[2] = {1, station_name_->lengths[1]};
      return file_.characters(*station_name_, start, count);
    }
  }
  std::string name;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const bool is_place = i != frequency_axis_ && i != direction_axis_ && density_.dimensions[i] != "time";
    if (!is_place || density_.lengths[i] < 2) continue;
    name += fmt::format("{}{} {}", name.empty() ? "" : ", ", density_.dimensions[i], start_[i] + 1);
  }
  return name;
}

std::string SpectraFile::time_here() const {
  const auto axis = density_.axis({"time"});
  if (!time_unit_ || !axis || start_[*axis] >= times_.size()) return {};
  return time_unit_->iso_time(times_[start_[*axis]]);
}

std::optional<WaveSpectrum> SpectraFile::spectrum_here() const {
  const double scale = scale_ ? value_here(scale_) : 1.0;
  const std::vector<double> values = file_.values(density_, start_, count_);
  const std::size_t nf = frequencies_hz_.size();
  const std::size_t nd = values.size() / nf;
  const bool frequency_is_faster = direction_axis_ && *direction_axis_ < *frequency_axis_;

  WaveSpectrum spectrum;
  std::vector<double> density;
  for (std::size_t i = 0; i < nf; ++i) {
    bool is_missing = std::isnan(scale);
    for (std::size_t j = 0; j < nd; ++j) {
      const double value = values[frequency_is_faster ? j * nf + i : i * nd + j];
      is_missing |= std::isnan(value);
      density.push_back(value * scale * unit_);
    }
    if (is_missing) {
      density.resize(density.size() - nd);
    } else {
      spectrum.frequencies_hz.push_back(frequencies_hz_[i]);
    }
  }
  if (spectrum.frequencies_hz.size() < 2) return std::nullopt;
  if (directions_) {
    set_density(spectrum, density, *directions_, place_name());
  } else {
    check_densities(density, place_name());
    spectrum.energy = std::move(density);
  }

  spectrum.station = station_here();
  spectrum.time_utc = time_here();
  const double latitude_deg = value_here(latitude_);
  const double longitude_deg = value_here(longitude_);
  const double depth_m = value_here(depth_);
  if (std::abs(latitude_deg) <= 90.0 && std::isfinite(longitude_deg)) {
    spectrum.latitude_deg = latitude_deg;
    spectrum.longitude_deg = longitude_deg;
  }
  if (depth_m > 0.0 && std::isfinite(depth_m)) spectrum.depth_m = depth_m;
  return spectrum;
}

bool SpectraFile::next_place() {
  for (std::size_t i = start_.size(); i-- > 0;) {
    if (i == frequency_axis_ || i == direction_axis_) continue;
    if (++start_[i] < density_.lengths[i]) return true;
    start_[i] = 0;
  }
  return false;
}

std::vector<WaveSpectrum> SpectraFile::read_all() {
  const bool is_empty =
      std::find(density_.lengths.begin(), density_.lengths.end(), std::size_t{0}) != density_.lengths.end();
  std::vector<WaveSpectrum> spectra;
  if (!is_empty) {
    do {
      if (auto spectrum = spectrum_here()) spectra.push_back(std::move(*spectrum));
    } while (next_place());
  }
  if (spectra.empty()) {
    file_.fail(fmt::format("{}: expected at least one spectrum with data, got none", density_.name),
               "choose times and points at sea: every density is missing here");
  }
  return spectra;
}

}  // namespace

std::vector<WaveSpectrum> parse_netcdf(std::span<const std::byte> bytes, std::string_view file_name) {
  return SpectraFile(bytes, file_name).read_all();
}

}  // namespace offing::spectra
