#pragma once

namespace offing::cli {

/// How much of the water foam of this coverage (0 ... 1) hides at a place on the sea: patches and threads
/// that move with the water, with the given coverage on average. Details below `footprint_m` are averaged
/// away.
float foam_opacity(double x_m, double z_m, float coverage, float footprint_m);

}  // namespace offing::cli
