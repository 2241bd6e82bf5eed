#include "host/cli/pictures/spectrum_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"
#include "host/cli/pictures/plot_canvas.h"

namespace offing::cli {
namespace {

constexpr int image_width = 1240, image_height = 620;
constexpr double left_px = 85, right_px = 610, top_px = 120, bottom_px = 555;  // frame of the frequency plot
constexpr Point rose{895, 335};
constexpr double rose_radius_px = 215;
constexpr double bar_left_px = 1150, bar_width_px = 18;
constexpr double text_px = 14, title_px = 19;

constexpr glm::vec3 grid_colour{0.88f, 0.88f, 0.88f};
constexpr glm::vec3 frame_colour{0.35f, 0.35f, 0.35f};
constexpr glm::vec3 curve_colour{0.05f, 0.32f, 0.55f};
constexpr glm::vec3 area_colour{0.78f, 0.88f, 0.94f};
/// From no energy to the most; each step is darker than the one before, so that the order survives without
/// colour.
constexpr std::array<glm::vec3, 6> density_colours{{{1.00f, 1.00f, 1.00f},
                                                    {0.78f, 0.91f, 0.88f},
                                                    {0.36f, 0.72f, 0.78f},
                                                    {0.13f, 0.45f, 0.67f},
                                                    {0.20f, 0.18f, 0.47f},
                                                    {0.16f, 0.02f, 0.16f}}};

/// Colour of this share of the largest density. The scale is a square root, so that a weak sea beside a
/// strong one shows.
glm::vec3 density_colour(double share) {
  const double place = std::sqrt(std::clamp(share, 0.0, 1.0)) * (density_colours.size() - 1);
  const std::size_t index = std::min(static_cast<std::size_t>(place), density_colours.size() - 2);
  return glm::mix(density_colours[index], density_colours[index + 1],
                  static_cast<float>(place - static_cast<double>(index)));
}

/// Frequency up to which the plots reach: the last that still has 1 % of the largest energy, and a fifth
/// more.
double shown_hz(const WaveSpectrum& record) {
  const double largest = *std::max_element(record.energy.begin(), record.energy.end());
  std::size_t last = record.energy.size() - 1;
  while (last > 0 && record.energy[last] < 0.01 * largest) --last;
  return largest > 0.0 ? std::min(1.2 * record.frequencies_hz[last], record.frequencies_hz.back())
                       : record.frequencies_hz.back();
}

/// E(f) D(f, theta), linear between the listed frequencies and directions; 0 outside the listed frequencies.
double density(const WaveSpectrum& record, double frequency_hz, double direction_rad) {
  const std::vector<double>& f = record.frequencies_hz;
  const auto above = std::upper_bound(f.begin(), f.end(), frequency_hz);
  if (above == f.begin() || above == f.end()) return 0.0;
  const std::size_t row = static_cast<std::size_t>(above - f.begin()) - 1;
  const double up = (frequency_hz - f[row]) / (f[row + 1] - f[row]);
  const std::size_t count = record.directions_rad.size();
  const double turn = 2.0 * std::numbers::pi;
  const double place = (direction_rad - record.directions_rad.front()) / turn;
  const double column = (place - std::floor(place)) * static_cast<double>(count);
  const std::size_t first = static_cast<std::size_t>(column) % count, second = (first + 1) % count;
  const double across = column - std::floor(column);
  const auto along_row = [&](std::size_t r) {
    const double* const spreading = &record.spreading[r * count];
    return record.energy[r] * std::lerp(spreading[first], spreading[second], across);
  };
  return std::lerp(along_row(row), along_row(row + 1), up);
}

void draw_heading(PlotCanvas& canvas, const WaveSpectrum& record, const ocean::SeaState& state) {
  std::string title = record.station.empty() ? "Wave spectrum" : record.station;
  if (!record.time_utc.empty()) title += "   " + record.time_utc;
  canvas.text({left_px, 34}, title, title_px, Align::left);
  std::string figures = fmt::format("Hs {:.2f} m   Tp {:.1f} s", state.hs_m, state.peak_period_s);
  if (record.depth_m) figures += fmt::format("   depth {:.4g} m", *record.depth_m);
  canvas.text({left_px, 62}, figures, text_px + 2, Align::left, curve_colour);
}

void draw_frequency_plot(PlotCanvas& canvas, const WaveSpectrum& record) {
  const double end_hz = shown_hz(record);
  const double largest = *std::max_element(record.energy.begin(), record.energy.end());
  const double end_energy = largest > 0.0 ? 1.08 * largest : 1.0;
  const auto x_of = [&](double hz) { return left_px + (right_px - left_px) * hz / end_hz; };
  const auto y_of = [&](double energy) { return bottom_px - (bottom_px - top_px) * energy / end_energy; };
  for (const double hz : round_ticks(end_hz, 7)) {
    canvas.line({{x_of(hz), top_px}, {x_of(hz), bottom_px}}, grid_colour, 1.0);
    canvas.text({x_of(hz), bottom_px + 18}, fmt::format("{:.4g}", hz), text_px, Align::center);
  }
  for (const double energy : round_ticks(end_energy, 6)) {
    canvas.line({{left_px, y_of(energy)}, {right_px, y_of(energy)}}, grid_colour, 1.0);
    canvas.text({left_px - 8, y_of(energy)}, fmt::format("{:.4g}", energy), text_px, Align::right);
  }
  double last_label_px = right_px + 18;
  for (const double period_s :
       {2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 30.0, 50.0, 100.0}) {
    const double x = x_of(1.0 / period_s);
    if (x > right_px || last_label_px - x < 26) continue;
    canvas.line({{x, top_px}, {x, top_px - 5}}, frame_colour, 1.0);
    canvas.text({x, top_px - 14}, fmt::format("{:g}", period_s), text_px, Align::center);
    last_label_px = x;
  }

  std::vector<Point> curve;
  for (std::size_t i = 0; i < record.energy.size(); ++i) {
    const double hz = record.frequencies_hz[i];
    if (hz <= end_hz) {
      curve.push_back({x_of(hz), y_of(record.energy[i])});
    } else {
      const double before_hz = record.frequencies_hz[i - 1], share = (end_hz - before_hz) / (hz - before_hz);
      curve.push_back({right_px, y_of(std::lerp(record.energy[i - 1], record.energy[i], share))});
      break;
    }
  }
  std::vector<Point> area = curve;
  area.push_back({curve.back().x, bottom_px});
  area.push_back({curve.front().x, bottom_px});
  canvas.polygon(area, area_colour);
  canvas.line(curve, curve_colour, 2.0);
  canvas.line({{left_px, top_px},
               {right_px, top_px},
               {right_px, bottom_px},
               {left_px, bottom_px},
               {left_px, top_px - 0.5}},
              frame_colour, 1.0);
  canvas.text({0.5 * (left_px + right_px), bottom_px + 42}, "frequency, Hz", text_px, Align::center);
  canvas.text({0.5 * (left_px + right_px), top_px - 34}, "period, s", text_px, Align::center);
  canvas.upward_text({26, 0.5 * (top_px + bottom_px)}, "variance density E(f), m\u00b2/Hz", text_px);
}

void draw_rose_grid(PlotCanvas& canvas, double end_hz, DirectionStyle style) {
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6.0;
    canvas.line(
        {rose, {rose.x + rose_radius_px * std::cos(angle), rose.y + rose_radius_px * std::sin(angle)}},
        {0.72f, 0.72f, 0.72f}, 0.6);
  }
  for (const double hz : round_ticks(end_hz, 4)) {
    if (hz <= 0.0) continue;
    const double radius = rose_radius_px * hz / end_hz;
    canvas.circle(rose, radius, {0.6f, 0.6f, 0.6f}, 0.8);
    // Labels run toward the lower left, between two spokes.
    canvas.text({rose.x - 0.7071 * radius, rose.y + 0.7071 * radius}, fmt::format("{:.4g} Hz", hz),
                text_px - 2, Align::center, frame_colour);
  }
  canvas.circle(rose, rose_radius_px, frame_colour, 1.2);
  const double outside = rose_radius_px + 16;
  canvas.text({rose.x, rose.y - outside}, "N", text_px, Align::center);
  canvas.text({rose.x + outside, rose.y}, "E", text_px, Align::center);
  canvas.text({rose.x, rose.y + outside}, "S", text_px, Align::center);
  canvas.text({rose.x - outside, rose.y}, "W", text_px, Align::center);
  canvas.text({rose.x, rose.y + outside + 26},
              style == DirectionStyle::travel ? "waves travel toward this side" : "waves come from this side",
              text_px, Align::center);
}

void draw_colour_bar(PlotCanvas& canvas, double largest) {
  const double top = rose.y - rose_radius_px, bottom = rose.y + rose_radius_px;
  for (int row = static_cast<int>(top); row < static_cast<int>(bottom); ++row) {
    const double height = (bottom - row) / (bottom - top);
    const glm::vec3 colour = density_colour(height * height);
    canvas.line({{bar_left_px, row + 0.5}, {bar_left_px + bar_width_px, row + 0.5}}, colour, 1.0);
  }
  for (const double value : round_ticks(largest, 5)) {
    const double y = bottom - (bottom - top) * std::sqrt(value / largest);
    canvas.line({{bar_left_px + bar_width_px, y}, {bar_left_px + bar_width_px + 5, y}}, frame_colour, 1.0);
    canvas.text({bar_left_px + bar_width_px + 9, y}, fmt::format("{:.3g}", value), text_px, Align::left);
  }
  canvas.line({{bar_left_px, top},
               {bar_left_px + bar_width_px, top},
               {bar_left_px + bar_width_px, bottom},
               {bar_left_px, bottom},
               {bar_left_px, top}},
              frame_colour, 1.0);
  canvas.text({bar_left_px + bar_width_px + 50, top - 20}, "E(f) D(f,\u03b8), m\u00b2/(Hz rad)", text_px,
              Align::right);
}

void draw_rose(PlotCanvas& canvas, const WaveSpectrum& record, DirectionStyle style) {
  const double end_hz = shown_hz(record);
  double largest = 0.0;
  const std::size_t directions = record.directions_rad.size();
  for (std::size_t i = 0; i < record.spreading.size(); ++i) {
    largest = std::max(largest, record.spreading[i] * record.energy[i / directions]);
  }
  if (!record.is_directional() || largest <= 0.0) {
    draw_rose_grid(canvas, end_hz, style);
    canvas.text({rose.x, rose.y - 14}, record.is_directional() ? "no energy" : "no directions in this record",
                text_px + 1, Align::center);
    return;
  }
  const int radius = static_cast<int>(rose_radius_px);
  const double sense = style == DirectionStyle::travel ? 1.0 : -1.0;  // from where, opposite to where to
  for (int row = -radius; row <= radius; ++row) {
    for (int column = -radius; column <= radius; ++column) {
      const double distance = std::hypot(column, row);
      if (distance > rose_radius_px) continue;
      // +x is east and +z south: just as the picture's columns and rows run with north up.
      const double value =
          density(record, end_hz * distance / rose_radius_px, std::atan2(sense * row, sense * column));
      canvas.pixel(static_cast<int>(rose.x) + column, static_cast<int>(rose.y) + row,
                   density_colour(value / largest));
    }
  }
  draw_rose_grid(canvas, end_hz, style);
  draw_colour_bar(canvas, largest);
}

}  // namespace

RgbImage draw_spectrum_plot(const WaveSpectrum& record, const ocean::SeaState& state, DirectionStyle style) {
  if (record.frequencies_hz.size() < 2 || record.energy.size() != record.frequencies_hz.size() ||
      record.spreading.size() !=
          record.directions_rad.size() * (record.is_directional() ? record.energy.size() : 0)) {
    throw Error(ErrorKind::bad_input,
                "plot: the record's energies and spreading do not match its frequencies",
                "pass a record as the readers return it");
  }
  PlotCanvas canvas(image_width, image_height);
  draw_heading(canvas, record, state);
  draw_frequency_plot(canvas, record);
  draw_rose(canvas, record, style);
  return canvas.image();
}

void write_spectrum_plot(const std::filesystem::path& path, const WaveSpectrum& record,
                         const ocean::SeaState& state, DirectionStyle style, Existing existing) {
  write_png(path, draw_spectrum_plot(record, state, style), existing);
}

}  // namespace offing::cli
