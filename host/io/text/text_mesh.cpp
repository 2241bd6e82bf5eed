#include "host/io/text/text_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <cairo.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "host/base/error.h"

namespace offing {
namespace {

constexpr std::size_t most_bytes = 64;
constexpr double font_size = 1000.0;  // of cairo's units, which outlines are rounded to 1/256 of
constexpr double tolerance = 1.0;     // of curves, in these units

using Outline = std::vector<glm::dvec2>;  // closed; the last point is joined to the first one

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_path_t* path) const { cairo_path_destroy(path); }
};

Error unusable(std::string_view text, std::string_view expected) {
  return {ErrorKind::bad_input, fmt::format("text: expected {}, got \"{}\"", expected, printable(text)),
          "write a letter or a word"};
}

/// A font draws a box in place of a letter that it does not have.
void require_glyphs(cairo_t* context, const std::string& text) {
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  const cairo_status_t status = cairo_scaled_font_text_to_glyphs(cairo_get_scaled_font(context), 0.0, 0.0,
                                                                 text.data(), static_cast<int>(text.size()),
                                                                 &glyphs, &count, nullptr, nullptr, nullptr);
  if (status != CAIRO_STATUS_SUCCESS) throw unusable(text, "text in UTF-8");
  const bool has_all =
      std::none_of(glyphs, glyphs + count, [](const cairo_glyph_t& glyph) { return glyph.index == 0; });
  cairo_glyph_free(glyphs);
  if (!has_all) throw unusable(text, "letters that the system's font has");
}

/// y up, in cairo's units.
std::vector<Outline> outlines_of(const std::string& text) {
  const std::unique_ptr<cairo_surface_t, Destroy> surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const std::unique_ptr<cairo_t, Destroy> context(cairo_create(surface.get()));
  cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  cairo_set_font_size(context.get(), font_size);
  cairo_set_tolerance(context.get(), tolerance);
  require_glyphs(context.get(), text);
  cairo_text_path(context.get(), text.c_str());
  if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) throw unusable(text, "text in UTF-8");
  const std::unique_ptr<cairo_path_t, Destroy> path(cairo_copy_path_flat(context.get()));
  std::vector<Outline> outlines;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* data = path->data + i;
    if (data->header.type == CAIRO_PATH_CLOSE_PATH) continue;
    if (data->header.type == CAIRO_PATH_MOVE_TO) outlines.emplace_back();
    const glm::dvec2 point(data[1].point.x, -data[1].point.y);
    if (outlines.back().empty() || outlines.back().back() != point) outlines.back().push_back(point);
  }
  std::erase_if(outlines, [](const Outline& outline) { return outline.size() < 3; });
  return outlines;
}

/// The wall of an outline, from z = -half_m to half_m.
void add_wall(const Outline& outline, double half_m, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const glm::dvec2& point : outline) {
    mesh.positions_m.emplace_back(point.x, point.y, -half_m);
    mesh.positions_m.emplace_back(point.x, point.y, half_m);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t here = first + 2 * i, next = first + 2 * ((i + 1) % count);
    mesh.faces.push_back({here, next, next + 1});
    mesh.faces.push_back({here, next + 1, here + 1});
  }
}

}  // namespace

TriangleMesh text_mesh(std::string_view text, const TextMeshOptions& options) {
  if (text.size() > most_bytes) throw unusable(text, fmt::format("at most {} bytes", most_bytes));
  std::vector<Outline> outlines = outlines_of(std::string(text));
  if (outlines.empty()) throw unusable(text, "letters that the system's font has");
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Outline& outline : outlines) {
    for (const glm::dvec2& point : outline) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  const glm::dvec2 middle = 0.5 * (low + high);
  const double scale = options.height_m / (high.y - low.y);
  TriangleMesh mesh;
  for (Outline& outline : outlines) {
    for (glm::dvec2& point : outline) point = scale * (point - middle);
    add_wall(outline, 0.5 * options.thickness_m, mesh);
  }
  return mesh;
}

}  // namespace offing
