// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <string>

#include "host/terrain/field/height_field.h"
#include "tests/bench/benches.h"
#include "tests/bench/terrain/terrain_maps.h"

namespace offing::bench {

/// Whole frames, rays and light, of the cameras that fly and of those that walk: a row each with the mean
/// over the cameras, with one ray a pixel (as the paper's frames) and with edges smoothed.
void bench_terrain_frames(const ocl::Device& device, const NamedMap& named, terrain::HeightField& field,
                          const Settings& settings, const Sinks& sinks);

}  // namespace offing::bench
