#include "host/io/spectra/spectrum_builder.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::spectra {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

// One degree: no model's bins are narrower, and those of whole degrees keep their centres.
constexpr std::size_t resampled_direction_count = 360;

// WAVEWATCH III prints directions with three digits, so to 0.005 rad from 1 rad up.
constexpr double printed_error_rad = 0.006;

// In [0, 2 pi). By fmod, which is exact: of 1e300 a floor and a product would leave 1e284.
double wrapped(double angle_rad) {
  double angle = std::fmod(angle_rad, turn_rad);
  if (angle < 0.0) angle += turn_rad;
  return angle < turn_rad ? angle : 0.0;
}

}  // namespace

void check_frequencies(std::span<const double> frequencies_hz, std::string_view where) {
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", where, what),
                "give frequencies in Hz, above 0, each greater than the one before");
  };
  if (frequencies_hz.size() < 2)
    fail(fmt::format("expected two or more frequencies, got {}", frequencies_hz.size()));
  double last_hz = 0.0;
  for (const double f_hz : frequencies_hz) {
    if (!std::isfinite(f_hz) || f_hz <= last_hz) {
      fail(fmt::format("expected a frequency above {:g} Hz, got {:g}", last_hz, f_hz));
    }
    last_hz = f_hz;
  }
}

void check_densities(std::span<const double> densities, std::string_view where) {
  for (const double value : densities) {
    if (value >= 0.0 && std::isfinite(value)) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a variance density >= 0, got {:g}", where, value),
                "the spectrum is damaged: get or write the file again");
  }
}

DirectionGrid::DirectionGrid(std::vector<double> directions_rad, std::string_view where) {
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", where, what),
                "give directions that cover the circle or a part of it, none twice");
  };
  if (directions_rad.size() > 2 &&
      std::abs(std::abs(directions_rad.back() - directions_rad.front()) - turn_rad) < printed_error_rad) {
    directions_rad.pop_back();
  }
  if (directions_rad.size() < 2)
    fail(fmt::format("expected two or more directions, got {}", directions_rad.size()));
  for (double& angle : directions_rad) {
    if (!std::isfinite(angle)) fail("expected finite directions");
    angle = wrapped(angle);
  }
  std::vector<std::size_t> order(directions_rad.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return directions_rad[a] < directions_rad[b]; });

  // Mean and greatest deviation from even spacing over the whole circle.
  const double spacing_rad = turn_rad / static_cast<double>(order.size());
  double first_rad = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && directions_rad[order[i]] - directions_rad[order[i - 1]] < 1e-9) {
      fail(fmt::format("direction {:.6g} rad (of travel) is listed twice", directions_rad[order[i]]));
    }
    first_rad += (directions_rad[order[i]] - static_cast<double>(i) * spacing_rad);
  }
  first_rad /= static_cast<double>(order.size());
  double deviation_rad = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double even_rad = first_rad + static_cast<double>(i) * spacing_rad;
    deviation_rad = std::max(deviation_rad, std::abs(directions_rad[order[i]] - even_rad));
  }
  if (deviation_rad < std::min(0.4 * spacing_rad, std::max(0.02 * spacing_rad, printed_error_rad))) {
    keep_even(order, first_rad);
  } else {
    resample(directions_rad, order);
  }
}

void DirectionGrid::keep_even(const std::vector<std::size_t>& order, double first_rad) {
  const double spacing_rad = turn_rad / static_cast<double>(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    directions_rad_.push_back(first_rad + static_cast<double>(i) * spacing_rad);
    deposits_.push_back({order[i], i, spacing_rad});
  }
}

void DirectionGrid::resample(const std::vector<double>& angles, const std::vector<std::size_t>& order) {
  const std::size_t n = order.size();
  // gap[i]: from direction i to the next one, in order and around the circle.
  std::vector<double> gaps(n);
  for (std::size_t i = 0; i < n; ++i) gaps[i] = wrapped(angles[order[(i + 1) % n]] - angles[order[i]]);
  std::vector<double> sorted_gaps = gaps;
  std::sort(sorted_gaps.begin(), sorted_gaps.end());
  // A gap much wider than the usual one lies outside the sector: bins do not reach into it further than to
  // the other side. With two directions there is no usual gap but the smaller one.
  const double usual_rad = sorted_gaps[(n - 1) / 2];
  const auto reach = [&](std::size_t i) {
    return gaps[i] <= 2.5 * usual_rad ? 0.5 * gaps[i] : 0.5 * usual_rad;
  };

  constexpr std::size_t count = resampled_direction_count;
  const double spacing_rad = turn_rad / static_cast<double>(count);
  for (std::size_t j = 0; j < count; ++j) directions_rad_.push_back(static_cast<double>(j) * spacing_rad);

  for (std::size_t i = 0; i < n; ++i) {
    // In units of output bins; bin j covers [j - 1/2, j + 1/2).
    const double begin = (angles[order[i]] - reach((i + n - 1) % n)) / spacing_rad + 0.5;
    const double end = (angles[order[i]] + reach(i)) / spacing_rad + 0.5;
    for (double bin = std::floor(begin); bin < end; bin += 1.0) {
      const double share = std::min(bin + 1.0, end) - std::max(bin, begin);
      if (share <= 0.0) continue;
      const auto offset = static_cast<long>(bin) + 2 * static_cast<long>(count);
      deposits_.push_back({order[i], static_cast<std::size_t>(offset) % count, share * spacing_rad});
    }
  }
}

double DirectionGrid::spread(std::span<const double> density, std::span<double> spreading) const {
  std::fill(spreading.begin(), spreading.end(), 0.0);
  double energy = 0.0;
  for (const Deposit& deposit : deposits_) {
    const double amount = density[deposit.source] * deposit.share_rad;
    spreading[deposit.target] += amount;
    energy += amount;
  }
  // Too little to divide by without losing digits: no waves.
  if (energy < DBL_MIN / DBL_EPSILON) {
    std::fill(spreading.begin(), spreading.end(), 0.0);
    return 0.0;
  }
  const double spacing_rad = turn_rad / static_cast<double>(spreading.size());
  for (double& value : spreading) value = value / energy / spacing_rad;
  return energy;
}

void fill_unknown_rows(WaveSpectrum& spectrum, std::span<const RowState> states) {
  const std::size_t nd = spectrum.directions_rad.size();
  const auto row = [&](std::size_t i) {
    return spectrum.spreading.begin() + static_cast<std::ptrdiff_t>(i * nd);
  };
  if (std::find(states.begin(), states.end(), RowState::known) == states.end()) {
    std::fill(spectrum.spreading.begin(), spectrum.spreading.end(), 1.0 / turn_rad);
    return;
  }
  // The nearest known row below and above, both in one sweep each.
  const std::size_t nf = states.size();
  std::vector<std::size_t> above(nf, nf);
  for (std::size_t i = nf, next = nf; i-- > 0;) above[i] = next = states[i] == RowState::known ? i : next;
  for (std::size_t i = 0, below = nf; i < nf; ++i) {
    if (states[i] == RowState::known) {
      below = i;
      continue;
    }
    const auto distance_hz = [&](std::size_t other) {
      return std::abs(spectrum.frequencies_hz[other] - spectrum.frequencies_hz[i]);
    };
    const bool takes_above = below == nf || (above[i] != nf && distance_hz(above[i]) < distance_hz(below));
    std::copy_n(row(takes_above ? above[i] : below), nd, row(i));
  }
}

void set_density(WaveSpectrum& spectrum, std::span<const double> density, const DirectionGrid& grid,
                 std::string_view where) {
  check_densities(density, where);
  const std::size_t nf = spectrum.frequencies_hz.size();
  const std::size_t nd = grid.directions_rad().size();
  spectrum.directions_rad = grid.directions_rad();
  spectrum.energy.assign(nf, 0.0);
  spectrum.spreading.assign(nf * nd, 0.0);
  std::vector<RowState> states(nf, RowState::known);
  for (std::size_t i = 0; i < nf; ++i) {
    const std::size_t width = density.size() / nf;
    spectrum.energy[i] =
        grid.spread(density.subspan(i * width, width), std::span(spectrum.spreading).subspan(i * nd, nd));
    if (spectrum.energy[i] == 0.0) states[i] = RowState::unknown;
  }
  check_densities(spectrum.energy, where);
  fill_unknown_rows(spectrum, states);
}

void set_moments(WaveSpectrum& spectrum, std::span<const ReportedMoments> moments) {
  const auto is_known = [](const ReportedMoments& m) { return m.kind != ReportedMoments::Kind::none; };
  if (std::none_of(moments.begin(), moments.end(), is_known)) return;
  spectrum.directions_rad.resize(direction_count);
  for (int j = 0; j < direction_count; ++j) spectrum.directions_rad[j] = turn_rad * j / direction_count;
  spectrum.spreading.assign(moments.size() * direction_count, 0.0);
  std::vector<RowState> states(moments.size(), RowState::known);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const SpreadingRow row(spectrum.spreading.begin() + static_cast<std::ptrdiff_t>(i * direction_count),
                           direction_count);
    switch (moments[i].kind) {
      case ReportedMoments::Kind::none:
        states[i] = RowState::unknown;
        break;
      case ReportedMoments::Kind::first:
        cosine_power_spreading(moments[i].moments.first, row);
        break;
      case ReportedMoments::Kind::both:
        maximum_entropy_spreading(moments[i].moments, row);
        break;
    }
  }
  fill_unknown_rows(spectrum, states);
}

}  // namespace offing::spectra
