// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/terrain/terrain_steps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "tests/bench/measure.h"

namespace offing::bench {
namespace {

using terrain::CastMethod;

struct NamedMethod {
  const char* name;
  CastMethod method;
};

constexpr std::array<NamedMethod, 4> methods{{{"parity", CastMethod::parity},
                                              {"paper", CastMethod::paper},
                                              {"pdm", CastMethod::pdm},
                                              {"linear", CastMethod::linear}}};

std::vector<terrain::Ray> rays_of(const Camera& camera) {
  std::vector<terrain::Ray> rays;
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const glm::dvec2 clip{2.0 * (column + 0.5) / camera.width_px - 1.0,
                            1.0 - 2.0 * (row + 0.5) / camera.height_px};
      rays.push_back({.origin_m = camera.eye_m, .direction = glm::normalize(ray_direction(camera, clip))});
    }
  }
  return rays;
}

/// Compares two methods' hits of the same rays and notes it in `steps`.
void compare_hits(const std::vector<terrain::Ray>& rays, const std::vector<terrain::RayHit>& a,
                  const std::vector<terrain::RayHit>& b, double cell_m, CameraSteps& steps) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (std::isinf(a[i].distance_m) != std::isinf(b[i].distance_m)) {
      ++steps.unlike;
    } else if (!std::isinf(a[i].distance_m)) {
      const glm::dvec3 normal(a[i].normal_x, a[i].normal_y, a[i].normal_z);
      const double facing = std::abs(glm::dot(normal, rays[i].direction));
      const double apart_m = std::abs(a[i].distance_m - b[i].distance_m);
      steps.worst_cells = std::max(steps.worst_cells, apart_m * facing / cell_m);
    }
  }
}

/// The median of three casts of a picture.
double cast_ms(terrain::HeightField& field, const ocl::Device& device, const Camera& camera,
               ocl::Buffer<TerrainHit>& hits, CastMethod method) {
  std::vector<double> times_ms;
  for (int i = 0; i < 3; ++i) {
    times_ms.push_back(once_ms([&] {
      field.cast(camera, hits, method);
      device.finish();
    }));
  }
  return median(times_ms);
}

CameraSteps steps_of_way(const std::string& way, terrain::HeightField& field, const ocl::Device& device,
                         const std::vector<TerrainCamera>& cameras) {
  const double cell_m = std::min(field.grid().spacing_x_m, field.grid().spacing_z_m);
  CameraSteps result;
  result.way = way;
  std::array<std::vector<terrain::RayHit>, methods.size()> all;
  std::array<double, methods.size()> times_ms{};
  std::vector<terrain::RayHit> of_images;
  for (const auto& [camera_way, camera] : cameras) {
    if (camera_way != way) continue;
    const std::vector<terrain::Ray> rays = rays_of(camera);
    result.rays += rays.size();
    ocl::Buffer<TerrainHit> picture(device, rays.size(), "hits");
    std::vector<terrain::RayHit> first;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const std::vector<terrain::RayHit> hits = field.cast(rays, methods[i].method);
      if (i == 0) first = hits;
      compare_hits(rays, first, hits, cell_m, result);
      all[i].insert(all[i].end(), hits.begin(), hits.end());
      times_ms[i] += cast_ms(field, device, camera, picture, methods[i].method);
    }
    field.cast(camera, picture);
    for (const TerrainHit& hit : picture.read()) of_images.push_back(terrain::ray_hit(hit, 0.0));
  }
  for (std::size_t i = 0; i < methods.size(); ++i) {
    result.methods.push_back({methods[i].name, step_statistics(all[i]), times_ms[i]});
  }
  result.methods.push_back({"picture", step_statistics(of_images), times_ms[0]});
  return result;
}

}  // namespace

StepStatistics step_statistics(const std::vector<terrain::RayHit>& hits) {
  std::vector<int> steps;
  for (const terrain::RayHit& hit : hits) steps.push_back(hit.steps);
  std::sort(steps.begin(), steps.end());
  const auto count = static_cast<double>(steps.size());
  double sum = 0.0;
  for (const int step : steps) sum += step;
  const auto of_share = [&](double share) {
    return steps[static_cast<std::size_t>(std::ceil(share * count)) - 1];
  };
  const auto up_to = [&](int most) {
    return static_cast<double>(std::upper_bound(steps.begin(), steps.end(), most) - steps.begin()) / count;
  };
  return {.mean = sum / count,
          .of_90 = of_share(0.90),
          .of_95 = of_share(0.95),
          .of_99 = of_share(0.99),
          .within_16 = up_to(16),
          .over_80 = 1.0 - up_to(80)};
}

std::vector<CameraSteps> camera_steps(terrain::HeightField& field, const ocl::Device& device,
                                      const std::vector<TerrainCamera>& cameras) {
  return {steps_of_way("fly", field, device, cameras), steps_of_way("walk", field, device, cameras)};
}

std::string text_of(const StepStatistics& steps) {
  return fmt::format("{:.2f} steps, 90 / 95 / 99 % within {} / {} / {}, {:.1f} % within 16, {:.2f} % over 80",
                     steps.mean, steps.of_90, steps.of_95, steps.of_99, 100.0 * steps.within_16,
                     100.0 * steps.over_80);
}

}  // namespace offing::bench
