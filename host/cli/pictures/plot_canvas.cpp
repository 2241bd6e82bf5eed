#include "host/cli/pictures/plot_canvas.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <cairo/cairo.h>

#include "host/base/error.h"

namespace offing::cli {
namespace {

void set_colour(cairo_t* context, glm::vec3 colour) {
  cairo_set_source_rgb(context, colour.x, colour.y, colour.z);
}

void trace(cairo_t* context, const std::vector<Point>& points) {
  cairo_new_path(context);
  for (const Point& point : points) cairo_line_to(context, point.x, point.y);
}

/// Draws at the current origin, the vertical middle of a capital letter on it.
void show_words(cairo_t* context, const std::string& words, double size_px, Align align) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size_px);
  cairo_text_extents_t extents;
  cairo_text_extents(context, words.c_str(), &extents);
  const double share = align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
  constexpr double half_capital = 0.36;  // of the font size, as common sans-serif faces have it
  cairo_move_to(context, -share * extents.x_advance, half_capital * size_px);
  cairo_show_text(context, words.c_str());
}

}  // namespace

struct PlotCanvas::State {
  State(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        context(cairo_create(surface)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  cairo_surface_t* surface;
  cairo_t* context;
};

PlotCanvas::~PlotCanvas() = default;

PlotCanvas::PlotCanvas(int width, int height) : state_(std::make_unique<State>(width, height)) {
  if (cairo_status(state_->context) != CAIRO_STATUS_SUCCESS) {
    throw Error(ErrorKind::out_of_memory,
                std::string("cannot make a plot: ") + cairo_status_to_string(cairo_status(state_->context)),
                "free memory and try again");
  }
  set_colour(state_->context, {1, 1, 1});
  cairo_paint(state_->context);
  cairo_set_line_join(state_->context, CAIRO_LINE_JOIN_ROUND);
}

void PlotCanvas::line(const std::vector<Point>& points, glm::vec3 colour, double width_px) {
  trace(state_->context, points);
  set_colour(state_->context, colour);
  cairo_set_line_width(state_->context, width_px);
  cairo_stroke(state_->context);
}

void PlotCanvas::polygon(const std::vector<Point>& points, glm::vec3 colour) {
  trace(state_->context, points);
  set_colour(state_->context, colour);
  cairo_fill(state_->context);
}

void PlotCanvas::circle(Point center, double radius_px, glm::vec3 colour, double width_px) {
  cairo_new_path(state_->context);
  cairo_arc(state_->context, center.x, center.y, radius_px, 0.0, 2.0 * std::numbers::pi);
  set_colour(state_->context, colour);
  cairo_set_line_width(state_->context, width_px);
  cairo_stroke(state_->context);
}

void PlotCanvas::pixel(int column, int row, glm::vec3 colour) {
  set_colour(state_->context, colour);
  cairo_rectangle(state_->context, column, row, 1, 1);
  cairo_fill(state_->context);
}

void PlotCanvas::text(Point anchor, const std::string& words, double size_px, Align align, glm::vec3 colour) {
  cairo_save(state_->context);
  set_colour(state_->context, colour);
  cairo_translate(state_->context, anchor.x, anchor.y);
  show_words(state_->context, words, size_px, align);
  cairo_restore(state_->context);
}

void PlotCanvas::upward_text(Point anchor, const std::string& words, double size_px) {
  cairo_save(state_->context);
  set_colour(state_->context, {0.15f, 0.15f, 0.15f});
  cairo_translate(state_->context, anchor.x, anchor.y);
  cairo_rotate(state_->context, -0.5 * std::numbers::pi);
  show_words(state_->context, words, size_px, Align::center);
  cairo_restore(state_->context);
}

RgbImage PlotCanvas::image() const {
  cairo_surface_flush(state_->surface);
  const unsigned char* const data = cairo_image_surface_get_data(state_->surface);
  const int stride = cairo_image_surface_get_stride(state_->surface);
  RgbImage image{
      cairo_image_surface_get_width(state_->surface), cairo_image_surface_get_height(state_->surface), {}};
  image.rgb.reserve(std::size_t{3} * image.width * image.height);
  for (int row = 0; row < image.height; ++row) {
    const auto* const pixels = reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t{row} * stride);
    for (int column = 0; column < image.width; ++column) {
      for (const int shift : {16, 8, 0})
        image.rgb.push_back(static_cast<std::uint8_t>(pixels[column] >> shift));
    }
  }
  return image;
}

std::vector<double> round_ticks(double end, int count) {
  const double rough = end / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough) step = factor * power;
  }
  std::vector<double> ticks;
  for (int i = 0; i * step <= end * (1.0 + 1e-9); ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace offing::cli
