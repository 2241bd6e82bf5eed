#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "host/base/cloud_volume.h"
#include "host/io/atomic_file.h"

namespace offing {

/// What a VDB file holds of a cloud.
struct VdbCloud {
  CloudVolume volume;
  /// One a value of volume.density, in its order: single-scattering albedo, linear Rec.709, 0 ... 1. Empty:
  /// not told.
  std::vector<std::array<float, 3>> albedo = {};
  bool tells_extinction = true;  ///< whether volume.extinction_per_m is the file's
};

/// How values are stored: as they are, or in half the room with 11 bits each.
enum class VdbPrecision { single, half };

/// Writes a cloud as a sparse OpenVDB file, atomically and with the same bytes for the same cloud: the fog
/// volume `density` (float), `color` (three floats) where there are albedos, both with places in metres of
/// the world, +y up, and the metadata `extinction_per_m`. A value is that of its cell's middle; cells without
/// density are not active, and those with it stored as they are, uncompressed: files are a fifth larger and
/// written in half the time. Values below 0 by no more than rounding (vdb_rounding) become 0.
///
/// Throws Error(bad_input) for a volume that does not keep what CloudVolume promises, or whose density is
/// above what VdbPrecision::half holds, Error(file) if it cannot be written.
void write_vdb(const std::filesystem::path& path, const VdbCloud& cloud,
               VdbPrecision precision = VdbPrecision::single, Existing existing = Existing::replace);

/// The largest volume that is read: a small file may hold large boxes of one value.
struct VdbLimits {
  std::size_t bricks = std::size_t{1} << 20;  ///< with density: 2 GiB
  std::size_t places = std::size_t{1} << 26;  ///< in the box around them
};

/// Reads the grid `grid` of an OpenVDB file, of float or double, and `color` or `Cd` where it has the same
/// cells. A file of write_vdb() gives the same volume again, but for bricks without density; of others the
/// volume begins at the first cell that has a value, rounded down to whole bricks of theirs, and its
/// extinction_per_m is 1 unless the file says it.
///
/// Throws Error(bad_input) that names the file and the place in it for what is no OpenVDB file or ends early,
/// for a grid that is missing, a level set, not of cubes along the axes, has values that are not finite,
/// clearly negative or everywhere, or is larger than the limits; Error(out_of_memory) for one that does not
/// fit into memory; Error(file) where it must not be read.
VdbCloud read_vdb(const std::filesystem::path& path, std::string_view grid = "density",
                  const VdbLimits& limits = {});

/// Values below 0 by less than this share of the largest are taken for rounding of sums of floats.
inline constexpr double vdb_rounding = 1e-3;

}  // namespace offing
