#include "host/highlights/search/highlight_points.h"

#include <algorithm>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "host/ocl/program.h"

namespace offing::highlights {
namespace {

bool are_neighbours(const HighlightSurface& surface, std::uint32_t a, std::uint32_t b) {
  const auto place = [&](std::uint32_t face, std::size_t corner) {
    return surface.links().place_of(surface.mesh().faces[face][corner]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (place(a, i) == place(b, j)) return true;
    }
  }
  return false;
}

/// Of points of one light on neighbouring faces that are one point within a tenth of a mean edge, the one
/// with the largest N.H, the first of equals. For searches that decide face by face.
std::vector<HighlightPoint> merged_points(const HighlightSurface& surface,
                                          const std::vector<HighlightPoint>& points) {
  const double reach_m = 0.1 * surface.mean_edge_m();
  std::vector<HighlightPoint> kept;
  for (const HighlightPoint& point : points) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const HighlightPoint& other) {
      return other.light == point.light && glm::distance(other.position_m, point.position_m) <= reach_m &&
             are_neighbours(surface, other.face, point.face);
    });
    if (same == kept.end()) {
      kept.push_back(point);
    } else if (point.n_dot_h > same->n_dot_h) {
      *same = point;
    }
  }
  return kept;
}

constexpr std::size_t first_capacity = 256;
// Of the printed method: how far outside a face a point may be, in weights, and how near N must be to H
// there.
constexpr float least_squares_tolerance = 1e-4f, least_squares_n_dot_h = 0.9999f;

HighlightPoint point_of(const HighlightSurface& surface, const HighlightRecord& record) {
  HighlightPoint point;
  point.face = static_cast<std::uint32_t>(record.face);
  point.light = record.light;
  point.orientation = record.orientation;
  point.weights = {record.weight_0, record.weight_1, record.weight_2};
  point.weights /= point.weights.x + point.weights.y + point.weights.z;
  point.position_m = place_on(surface, point.face, point.weights);
  point.normal = glm::normalize(glm::dvec3(record.normal_x, record.normal_y, record.normal_z));
  const glm::dvec3 e_max(record.e_max_x, record.e_max_y, record.e_max_z);
  point.e_max = glm::normalize(e_max - glm::dot(e_max, point.normal) * point.normal);
  point.k_max_per_m = record.k_max_perm;
  point.k_min_per_m = record.k_min_perm;
  point.n_dot_h = record.n_dot_h;
  return point;
}

}  // namespace

glm::dvec3 place_on(const HighlightSurface& surface, std::uint32_t face, const glm::dvec3& weights) {
  const TriangleIndices& corners = surface.mesh().faces[face];
  const std::vector<glm::dvec3>& positions_m = surface.mesh().positions_m;
  return weights.x * positions_m[corners[0]] + weights.y * positions_m[corners[1]] +
         weights.z * positions_m[corners[2]];
}

HighlightFinder::HighlightFinder(const ocl::Device& device)
    : device_(device),
      field_tuning_(ocl::tuning_for(device.info(), "highlight_field")),
      points_tuning_(ocl::tuning_for(device.info(), "highlight_points")),
      field_kernel_(ocl::Program::build(device, "highlights/highlight_field.cl",
                                        ocl::Defines().set("LANES", field_tuning_.lanes))
                        .kernel("highlight_field")),
      points_kernel_(
          ocl::Program::build(device, "highlights/highlight_points.cl").kernel("highlight_points")),
      least_squares_kernel_(
          ocl::Program::build(device, "highlights/least_squares_points.cl").kernel("least_squares_points")),
      lights_(device, HIGHLIGHT_LIGHTS, "highlight lights"),
      count_(device, 1, "highlight count"),
      records_(device, first_capacity, "highlight points") {}

void HighlightFinder::launch_zeros(const HighlightSurface& surface, int first_light, int light_count) {
  const int pitch = surface.pitch();
  const std::size_t floats = 2 * static_cast<std::size_t>(light_count) * static_cast<std::size_t>(pitch);
  if (field_.size() < floats) field_ = ocl::Buffer<float>(device_, floats, "highlight field");
  if (masks_.size() < static_cast<std::size_t>(pitch))
    masks_ = ocl::Buffer<std::uint32_t>(device_, static_cast<std::size_t>(pitch), "highlight masks");
  field_kernel_.launch(ocl::launch_shape(field_tuning_, static_cast<std::size_t>(pitch)),
                       surface.vertex_rows(), pitch, lights_, light_count, field_tuning_.per_item,
                       first_light == 0 ? 1 : 0, field_, masks_, count_);
  const int face_count = static_cast<int>(surface.mesh().faces.size());
  if (face_count == 0) return;
  points_kernel_.launch(ocl::launch_shape(points_tuning_, static_cast<std::size_t>(face_count)),
                        surface.vertex_rows(), pitch, surface.face_rows(), face_count,
                        points_tuning_.per_item, lights_, first_light, field_, masks_, records_,
                        static_cast<int>(records_.size()), count_);
}

void HighlightFinder::launch_least_squares(const HighlightSurface& surface, int first_light,
                                           int light_count) {
  if (first_light == 0) count_.fill(0);
  const int face_count = static_cast<int>(surface.mesh().faces.size());
  if (face_count == 0) return;
  least_squares_kernel_.launch({{static_cast<std::size_t>(face_count)}}, surface.vertex_rows(),
                               surface.pitch(), surface.face_rows(), face_count, lights_, light_count,
                               first_light, least_squares_tolerance, least_squares_n_dot_h, records_,
                               static_cast<int>(records_.size()), count_);
}

int HighlightFinder::search(const HighlightSurface& surface, const Lighting& lighting, SearchMethod method) {
  const int all = static_cast<int>(lighting.lights.size());
  for (int first = 0; first < all; first += HIGHLIGHT_LIGHTS) {
    std::vector<HighlightLight> lights;
    for (int light = first; light < std::min(all, first + HIGHLIGHT_LIGHTS); ++light) {
      lights.push_back(
          packed_light(lighting.eye, lighting.lights[static_cast<std::size_t>(light)], surface.middle_m()));
    }
    lights_.write(lights);
    const int count = static_cast<int>(lights.size());
    if (method == SearchMethod::zeros) {
      launch_zeros(surface, first, count);
    } else {
      launch_least_squares(surface, first, count);
    }
  }
  return count_.map()[0];
}

std::vector<HighlightPoint> HighlightFinder::find(const HighlightSurface& surface, const Lighting& lighting,
                                                  SearchMethod method) {
  if (lighting.lights.empty()) return {};
  auto count = static_cast<std::size_t>(search(surface, lighting, method));
  if (count > records_.size()) {
    records_ = ocl::Buffer<HighlightRecord>(device_, 2 * count, "highlight points");
    count = static_cast<std::size_t>(search(surface, lighting, method));
  }
  std::vector<HighlightPoint> points;
  if (count == 0) return points;
  {
    const auto records = records_.map();
    for (const HighlightRecord& record : records.span().first(count))
      points.push_back(point_of(surface, record));
  }
  // Work-items append in any order.
  std::sort(points.begin(), points.end(), [](const HighlightPoint& a, const HighlightPoint& b) {
    return std::tie(a.light, a.face) < std::tie(b.light, b.face);
  });
  return method == SearchMethod::zeros ? points : merged_points(surface, points);
}

}  // namespace offing::highlights
