#include "host/io/hydrodynamics/wamit_files.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::hydrodynamics {
namespace {

using spectra::TextCursor;
using std::numbers::pi;

constexpr const char* columns_hint =
    "write the numeric output files of WAMIT again, for one body and with periods in s";
// 72 directions of 1000 periods; more would be another file.
constexpr std::size_t most_entries = 200000;

/// Numbers of the present line.
std::vector<double> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  while (const std::optional<double> number = spectra::take_number(line)) numbers.push_back(*number);
  if (!spectra::is_blank(line)) numbers.clear();
  return numbers;
}

std::size_t motion_of(const TextCursor& cursor, double index) {
  if (index == std::floor(index) && index >= 1.0 && index <= static_cast<double>(hull_motions)) {
    return static_cast<std::size_t>(index) - 1;
  }
  cursor.fail("a motion from 1 to 6", fmt::format("{:g}", index), columns_hint);
}

/// Calls take(cursor, numbers) for each line with numbers; the first one may be a title.
template <typename Take>
void each_line(const WamitText& file, std::string_view columns, std::size_t least, std::size_t most,
               const Take& take) {
  TextCursor cursor(file.text, file.name);
  bool is_first = true, is_empty = true;
  while (cursor.next_filled_line()) {
    const std::vector<double> numbers = numbers_of(cursor.line());
    if (numbers.empty() && is_first) {
      is_first = false;
      continue;
    }
    is_first = false;
    if (numbers.size() < least || numbers.size() > most) {
      cursor.fail(columns, numbers.empty() ? "no numbers" : fmt::format("{} numbers", numbers.size()),
                  columns_hint);
    }
    is_empty = false;
    take(cursor, numbers);
  }
  if (is_empty) cursor.fail(columns, "a file without numbers", columns_hint);
}

double length_power(double length_m, std::size_t i, std::size_t j, int least) {
  return std::pow(length_m, least + (i >= 3 ? 1 : 0) + (j >= 3 ? 1 : 0));
}

struct Radiation {
  HullMatrix added_mass{}, damping{};
};

/// Frequencies are told apart by the period as it is written, which both files do alike.
using ByPeriod = std::map<double, Radiation>;

double frequency_of(double period_s) {
  if (period_s == 0.0) return std::numeric_limits<double>::infinity();
  return period_s < 0.0 ? 0.0 : 2.0 * pi / period_s;
}

ByPeriod read_radiation(const WamitText& file, const WamitUnits& units) {
  ByPeriod found;
  each_line(file, "PER I J A B", 4, 5, [&](const TextCursor& cursor, const std::vector<double>& n) {
    const bool is_limit = n[0] <= 0.0;
    if (!is_limit && n.size() < 5) cursor.fail("PER I J A B", "4 numbers", columns_hint);
    const std::size_t i = motion_of(cursor, n[1]), j = motion_of(cursor, n[2]);
    Radiation& at = found[std::max(n[0], -1.0)];
    const double scale = units.density_kgpm3 * length_power(units.length_m, i, j, 3);
    at.added_mass[hull_motions * i + j] = n[3] * scale;
    if (!is_limit) at.damping[hull_motions * i + j] = n[4] * scale * frequency_of(n[0]);
    if (found.size() > most_entries) cursor.fail("fewer periods", "too many", columns_hint);
  });
  return found;
}

/// By period, then by direction in degrees.
using Waves = std::map<double, std::map<double, HullWrench>>;

Waves read_excitation(const WamitText& file, const WamitUnits& units) {
  Waves found;
  std::size_t entries = 0;
  each_line(
      file, "PER BETA I Mod Pha Re Im", 7, 7, [&](const TextCursor& cursor, const std::vector<double>& n) {
        if (n[0] <= 0.0) return;  // limits without waves
        const std::size_t i = motion_of(cursor, n[2]);
        const double scale = units.density_kgpm3 * units.gravity_mps2 * length_power(units.length_m, i, 0, 2);
        // e^(+i omega t) there, e^(-i omega t) here.
        const auto [place, is_new] = found[n[0]].try_emplace(n[1]);
        place->second[i] = {n[5] * scale, -n[6] * scale};
        if (is_new && ++entries > most_entries) cursor.fail("fewer waves", "too many", columns_hint);
      });
  return found;
}

/// The waves of a period of the other file: both are rounded to the same digits, or nearly so.
const std::map<double, HullWrench>* waves_of(const Waves& waves, double period_s) {
  const auto found = waves.lower_bound(period_s * (1.0 - 1e-6));
  return found != waves.end() && found->first <= period_s * (1.0 + 1e-6) ? &found->second : nullptr;
}

}  // namespace

HydrodynamicFile parse_wamit(const WamitText& radiation, const WamitText& excitation,
                             const std::optional<WamitText>& restoring, const WamitUnits& units) {
  const auto fail = [](std::string_view name, const std::string& what) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", spectra::printable_name(name), what),
                columns_hint);
  };
  HydrodynamicTable table;
  table.name = radiation.name;
  table.density_kgpm3 = units.density_kgpm3;
  table.gravity_mps2 = units.gravity_mps2;
  const ByPeriod periods = read_radiation(radiation, units);
  const Waves waves = read_excitation(excitation, units);
  if (waves.empty()) fail(excitation.name, "expected a period above 0, found none");
  for (const auto& [direction_deg, wrench] : waves.begin()->second)
    table.directions_rad.push_back(direction_deg * pi / 180.0);
  for (const auto& [period_s, values] : periods) {
    table.frequencies_radps.push_back(frequency_of(period_s));
    table.added_mass.push_back(values.added_mass);
    table.damping.push_back(values.damping);
    const std::map<double, HullWrench>* at = period_s > 0.0 ? waves_of(waves, period_s) : nullptr;
    if (period_s > 0.0 && at == nullptr) {
      fail(excitation.name, fmt::format("expected waves of the period {:g} s of {}, found none", period_s,
                                        spectra::printable_name(radiation.name)));
    }
    if (at == nullptr) {
      table.excitation.resize(table.excitation.size() + table.directions_rad.size());
      continue;
    }
    if (at->size() != table.directions_rad.size()) {
      fail(excitation.name, fmt::format("expected {} directions at the period {:g} s as at the first, got {}",
                                        table.directions_rad.size(), period_s, at->size()));
    }
    std::size_t column = 0;
    for (const auto& [direction_deg, wrench] : *at) {
      if (std::abs(direction_deg * pi / 180.0 - table.directions_rad[column]) > 1e-6) {
        fail(excitation.name,
             fmt::format("expected the direction {:g} degrees at the period {:g} s, got {:g}",
                         table.directions_rad[column] * 180.0 / pi, period_s, direction_deg));
      }
      table.excitation.push_back(wrench);
      ++column;
    }
  }
  if (restoring) {
    HullMatrix c{};
    each_line(*restoring, "I J C", 3, 3, [&](const TextCursor& cursor, const std::vector<double>& n) {
      const std::size_t i = motion_of(cursor, n[0]), j = motion_of(cursor, n[1]);
      c[hull_motions * i + j] =
          n[2] * units.density_kgpm3 * units.gravity_mps2 * length_power(units.length_m, i, j, 2);
    });
    table.restoring = c;
  }
  return in_hull_axes(table);
}

}  // namespace offing::hydrodynamics
