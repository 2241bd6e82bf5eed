// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <string>
#include <vector>

#include "host/terrain/field/height_field.h"
#include "tests/bench/step_statistics.h"
#include "tests/bench/terrain/terrain_cameras.h"

namespace offing::bench {

/// Of at least one hit or miss.
StepStatistics step_statistics(const std::vector<terrain::RayHit>& hits);

/// What the pixels' rays of all cameras of a way take.
struct CameraSteps {
  struct Method {
    std::string name;
    StepStatistics steps;
    double ms = 0.0;  ///< to cast the pictures of all cameras into hits, device memory to device memory
  };
  std::string way;
  std::vector<Method> methods;  ///< "parity", "paper", "pdm", "linear", each ray on its own, and "picture"
  /// |t - t'| |n.d| between any method and the first, of rays that both hit, in cells; and how many rays
  /// only one of them hits.
  double worst_cells = 0.0;
  std::size_t unlike = 0, rays = 0;
};

/// Of cameras that fly and of those that walk. "picture" is what HeightField::cast(camera) takes: on a CPU a
/// ray's share of the steps that 64 pixels share, rounded up.
std::vector<CameraSteps> camera_steps(terrain::HeightField& field, const ocl::Device& device,
                                      const std::vector<TerrainCamera>& cameras);

std::string text_of(const StepStatistics& steps);

}  // namespace offing::bench
