#include "host/io/spectra/write_ww3_spectra.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/atomic_file.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/text_cursor.h"

namespace offing {
namespace {

constexpr std::size_t name_length = 10;
constexpr double unknown = -999.0;

// Fortran programs may read two-digit exponents only.
constexpr double smallest_printed = 1e-99;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", spectra::printable_name(path.string()), what),
              hint);
}

// Other readers of this format, wavespectra among them, take counts of two digits only.
constexpr std::size_t most_counted = 99;

// Of more directions than that: a whole number of them becomes one where that leaves enough.
std::size_t written_directions(std::size_t count) {
  constexpr std::size_t fewest = 36, usual = 90;
  for (std::size_t merged = 2; count / merged >= fewest; ++merged) {
    if (count % merged == 0 && count / merged <= most_counted) return count / merged;
  }
  return usual;
}

// Energy stays where it is but for the width of the cells: each takes its share of those that it covers.
void coarsen_directions(WaveSpectrum& spectrum, std::size_t count) {
  const std::size_t given = spectrum.directions_rad.size(), rows = spectrum.frequencies_hz.size();
  const double ratio = static_cast<double>(given) / static_cast<double>(count);
  std::vector<double> directions_rad(count), spreading(rows * count, 0.0);
  const double step_rad = 2.0 * std::numbers::pi / static_cast<double>(given);
  for (std::size_t to = 0; to < count; ++to) {
    // Cell borders in given cells, from the first one's lower border on.
    const double begin = ratio * static_cast<double>(to), end = begin + ratio;
    directions_rad[to] = spectrum.directions_rad[0] + step_rad * (0.5 * (begin + end) - 0.5);
    for (auto from = static_cast<std::size_t>(begin); from < given && static_cast<double>(from) < end;
         ++from) {
      const double low = std::max(begin, static_cast<double>(from)),
                   high = std::min(end, static_cast<double>(from + 1));
      for (std::size_t row = 0; row < rows; ++row)
        spreading[row * count + to] += (high - low) / ratio * spectrum.spreading[row * given + from];
    }
  }
  spectrum.directions_rad = std::move(directions_rad);
  spectrum.spreading = std::move(spreading);
}

// Evenly among the given ones, from the first to the last; the variance stays.
void coarsen_frequencies(WaveSpectrum& spectrum, std::size_t count) {
  const std::size_t given = spectrum.frequencies_hz.size(), directions = spectrum.directions_rad.size();
  WaveSpectrum coarse = spectrum;
  coarse.frequencies_hz.clear();
  coarse.energy.clear();
  coarse.spreading.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double place =
        static_cast<double>(i) * static_cast<double>(given - 1) / static_cast<double>(count - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(place), given - 2);
    const double share = place - static_cast<double>(before);
    const auto between = [&](double low, double high) { return std::lerp(low, high, share); };
    coarse.frequencies_hz.push_back(
        between(spectrum.frequencies_hz[before], spectrum.frequencies_hz[before + 1]));
    coarse.energy.push_back(between(spectrum.energy[before], spectrum.energy[before + 1]));
    for (std::size_t j = 0; j < directions; ++j) {
      const std::size_t at = before * directions + j;
      coarse.spreading.push_back(between(spectrum.spreading[at], spectrum.spreading[at + directions]));
    }
  }
  const double scale = variance_m2(coarse) > 0.0 ? variance_m2(spectrum) / variance_m2(coarse) : 1.0;
  for (double& energy : coarse.energy) energy *= scale;
  spectrum = std::move(coarse);
}

WaveSpectrum with_counts_of_two_digits(WaveSpectrum spectrum) {
  const std::size_t directions = spectrum.directions_rad.size();
  if (directions > most_counted) coarsen_directions(spectrum, written_directions(directions));
  if (spectrum.frequencies_hz.size() > most_counted) coarsen_frequencies(spectrum, most_counted);
  return spectrum;
}

std::vector<const WaveSpectrum*> oldest_first(std::span<const WaveSpectrum> spectra) {
  std::vector<const WaveSpectrum*> sorted;
  for (const WaveSpectrum& spectrum : spectra) sorted.push_back(&spectrum);
  std::ranges::stable_sort(sorted, {}, [](const WaveSpectrum* each) { return each->time_utc; });
  return sorted;
}

// How many spectra share the first one's time; checks that the others repeat that.
std::size_t points_a_time(const std::filesystem::path& path, std::span<const WaveSpectrum* const> spectra) {
  const auto same_time = [&](std::size_t begin) {
    std::size_t end = begin;
    while (end < spectra.size() && spectra[end]->time_utc == spectra[begin]->time_utc) ++end;
    return end - begin;
  };
  const std::size_t points = same_time(0);
  for (std::size_t begin = points; begin < spectra.size(); begin += points) {
    if (same_time(begin) == points) continue;
    fail(path,
         fmt::format("expected {} spectra at {}, got {}", points, spectra[begin]->time_utc, same_time(begin)),
         "this format needs the same points at every time; write one record");
  }
  return points;
}

std::string grid_text(const WaveSpectrum& spectrum) {
  const std::vector<double>& f_hz = spectrum.frequencies_hz;
  return fmt::format("{} frequencies {:.6g} ... {:.6g} Hz, {} directions", f_hz.size(), f_hz.front(),
                     f_hz.back(), spectrum.directions_rad.size());
}

void check_alike(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra) {
  if (spectra.empty()) fail(path, "expected spectra to write, got none", "choose a file that holds records");
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    if (!spectra[i].is_directional()) {
      fail(path, fmt::format("record {}: expected a directional spectrum, got one without directions", i),
           "this format cannot hold it; put the directional files of the buoy beside its .data_spec");
    }
    if (spectra[i].frequencies_hz != spectra[0].frequencies_hz ||
        spectra[i].directions_rad != spectra[0].directions_rad) {
      fail(
          path,
          fmt::format("record {}: expected the grid of record 0 ({}), got another ({})", i,
                      grid_text(spectra[0]), grid_text(spectra[i])),
          "this format has one grid for all records; write each record, chosen by --record, to its own file");
    }
  }
}

// Values in lines of `per_line`.
void append_values(std::string& text, std::span<const double> values, std::size_t per_line) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = std::abs(values[i]) < smallest_printed ? 0.0 : values[i];
    fmt::format_to(std::back_inserter(text), " {:.6E}{}", value,
                   i + 1 == values.size() || (i + 1) % per_line == 0 ? "\n" : "");
  }
}

// 'name      ', quotes doubled as Fortran does.
std::string quoted_name(const std::string& station) {
  std::string name;
  for (const char c : station.substr(0, name_length)) {
    const auto byte = static_cast<unsigned char>(c);
    name += byte < 0x20 || byte >= 0x7f ? ' ' : c;
  }
  name.resize(name_length, ' ');
  std::string quoted = "'";
  for (const char c : name) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string time_line(const WaveSpectrum& spectrum) {
  const UtcTime t = parse_iso_time(spectrum.time_utc).value_or(UtcTime{1, 1, 1, 0, 0, 0});
  return fmt::format("{:04}{:02}{:02} {:02}{:02}{:02}\n", t.year, t.month, t.day, t.hour, t.minute, t.second);
}

// WAVEWATCH III lists directions counterclockwise from east: bearings fall from pi/2 on, around the circle.
std::vector<std::size_t> ww3_order(std::span<const double> bearings_rad) {
  const auto turn_from_east = [&](std::size_t i) {
    const double turn = std::fmod(2.5 * std::numbers::pi - bearings_rad[i], 2.0 * std::numbers::pi);
    return turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
  };
  std::vector<std::size_t> order(bearings_rad.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return turn_from_east(a) < turn_from_east(b); });
  return order;
}

/// Hands over the text of a file record by record.
void make_text(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra,
               const std::function<void(std::string_view)>& write) {
  check_alike(path, spectra);
  const std::vector<const WaveSpectrum*> sorted = oldest_first(spectra);
  const std::size_t points = points_a_time(path, sorted);
  const WaveSpectrum first = with_counts_of_two_digits(*sorted.front());
  const std::size_t nf = first.frequencies_hz.size();
  const std::size_t nd = first.directions_rad.size();

  std::vector<double> bearings_rad(nd);
  for (std::size_t j = 0; j < nd; ++j) {
    const double bearing_rad = spectra::travel_bearing(first.directions_rad[j]);
    const double turns = bearing_rad / (2.0 * std::numbers::pi);
    bearings_rad[j] = bearing_rad - 2.0 * std::numbers::pi * std::floor(turns);
  }
  const std::vector<std::size_t> order = ww3_order(bearings_rad);
  std::vector<double> ordered_rad;
  for (const std::size_t j : order) ordered_rad.push_back(bearings_rad[j]);

  std::string text = fmt::format(
      "'WAVEWATCH III SPECTRA' {:5} {:5} {:5} 'written by Offing                '\n", nf, nd, points);
  append_values(text, first.frequencies_hz, 8);
  append_values(text, ordered_rad, 7);
  std::vector<double> density(nf * nd);
  for (std::size_t record = 0; record < sorted.size(); ++record) {
    const WaveSpectrum spectrum = with_counts_of_two_digits(*sorted[record]);
    if (record % points == 0) text += time_line(spectrum);
    text += fmt::format("{} {:.4f} {:.4f} {:.2f} 0.00 0.0 0.00 0.0\n", quoted_name(spectrum.station),
                        spectrum.latitude_deg.value_or(unknown), spectrum.longitude_deg.value_or(unknown),
                        spectrum.depth_m.value_or(unknown));
    for (std::size_t j = 0; j < nd; ++j) {
      for (std::size_t i = 0; i < nf; ++i) {
        density[j * nf + i] = spectrum.energy[i] * spectrum.spreading[i * nd + order[j]];
      }
    }
    append_values(text, density, 7);
    write(text);
    text.clear();
  }
}

}  // namespace

std::string ww3_text(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra) {
  std::string text;
  make_text(path, spectra, [&](std::string_view part) { text += part; });
  return text;
}

void write_ww3_spectra(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra,
                       Existing existing) {
  std::optional<AtomicFile> file;  // not before there is something to write
  make_text(path, spectra, [&](std::string_view part) {
    if (!file) file.emplace(path, existing);
    file->write(part);
  });
  file->commit();
}

}  // namespace offing
