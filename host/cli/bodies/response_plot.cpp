#include "host/cli/bodies/response_plot.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "host/cli/pictures/plot_canvas.h"

namespace offing::cli {
namespace {

constexpr int image_width = 1240, image_height = 760;
constexpr double panel_width_px = 310, panel_height_px = 240, text_px = 14;
constexpr glm::vec3 grid_colour{0.88f, 0.88f, 0.88f}, frame_colour{0.35f, 0.35f, 0.35f};
// From light to dark, so that the order survives without colour.
constexpr std::array<glm::vec3, 6> colours{{{0.98f, 0.62f, 0.10f},
                                            {0.36f, 0.72f, 0.78f},
                                            {0.85f, 0.25f, 0.25f},
                                            {0.13f, 0.45f, 0.67f},
                                            {0.25f, 0.50f, 0.20f},
                                            {0.20f, 0.18f, 0.47f}}};

void draw_panel(PlotCanvas& canvas, std::size_t motion, const std::vector<double>& periods_s,
                const std::vector<ResponseCurve>& curves) {
  const bool is_turn = motion >= 3;
  const double scale = is_turn ? 180.0 / std::numbers::pi : 1.0;
  const double left = 80 + 400 * static_cast<double>(motion % 3),
               top = 110 + 340 * static_cast<double>(motion / 3);
  const double right = left + panel_width_px, bottom = top + panel_height_px;
  double most = 0.0;
  for (const ResponseCurve& curve : curves) {
    for (const Response& response : curve.responses)
      most = std::max(most, scale * response.amplitude[motion]);
  }
  // Motions that symmetry forbids are zero but for rounding.
  const double end = most > 1e-6 ? 1.08 * most : 1.0;
  const double first = periods_s.front(), last = std::max(periods_s.back(), first * (1.0 + 1e-9));
  const auto x_of = [&](double period) { return left + (right - left) * (period - first) / (last - first); };
  const auto y_of = [&](double value) { return bottom - (bottom - top) * value / end; };
  for (const double tick : round_ticks(last, 8)) {
    if (tick < first) continue;
    canvas.line({{x_of(tick), top}, {x_of(tick), bottom}}, grid_colour, 1.0);
    canvas.text({x_of(tick), bottom + 16}, fmt::format("{:.4g}", tick), text_px, Align::center);
  }
  for (const double tick : round_ticks(end, 5)) {
    canvas.line({{left, y_of(tick)}, {right, y_of(tick)}}, grid_colour, 1.0);
    canvas.text({left - 6, y_of(tick)}, fmt::format("{:.3g}", tick), text_px, Align::right);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < periods_s.size(); ++k)
      points.push_back({x_of(periods_s[k]), y_of(scale * curves[i].responses[k].amplitude[motion])});
    canvas.line(points, colours[i % colours.size()], 2.0);
  }
  canvas.line({{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top - 0.5}}, frame_colour,
              1.0);
  canvas.text({0.5 * (left + right), top - 14},
              fmt::format("{}, {}", motion_names[motion], is_turn ? "\u00b0/m" : "m/m"), text_px + 1,
              Align::center);
  canvas.text({0.5 * (left + right), bottom + 36}, "period, s", text_px, Align::center);
}

}  // namespace

RgbImage draw_response_plot(const std::string& title, const std::vector<double>& periods_s,
                            const std::vector<ResponseCurve>& curves) {
  PlotCanvas canvas(image_width, image_height);
  canvas.text({80, 30}, title, 19, Align::left);
  double x = 80;
  for (std::size_t i = 0; i < curves.size() && x < image_width - 120; ++i) {
    canvas.line({{x, 62}, {x + 22, 62}}, colours[i % colours.size()], 3.0);
    canvas.text({x + 28, 62}, curves[i].label, text_px, Align::left);
    x += 90;
  }
  for (std::size_t motion = 0; motion < hull_motions; ++motion) draw_panel(canvas, motion, periods_s, curves);
  return canvas.image();
}

}  // namespace offing::cli
