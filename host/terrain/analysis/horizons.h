#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/field/height_field.h"

namespace offing::terrain {

/// Azimuths into which the turn is divided, unless somebody asks for others.
inline constexpr int usual_azimuths = 64;
inline constexpr int fewest_azimuths = 8, most_azimuths = 720;

/// Throws Error(bad_input) that names `azimuths` unless it is within fewest_azimuths ... most_azimuths.
void require_azimuths(int azimuths);

/// A band of whole rows of a map.
struct RowBand {
  int first_row = 0, rows = 0;
};

/// The horizons of a map's posts by azimuth, a band of rows at a time: at which rise, m/m, a ray from the
/// post passes over all ground that lies its way, on the surface of bilinear patches that rays hit (Max 1988,
/// Horizon mapping). Azimuths are clockwise from the map's north, -z. Ground may hide the sky up to 0.001 of
/// rise higher than is said, not lower (tests/terrain/analysis/horizons_test.cpp). A horizon is never below
/// level: what lies beyond the map is taken to be level and no higher. Ground lies lower by curve, as for
/// lines of sight.
///
/// The field must outlive it. at() enqueues. Every call may throw Error(out_of_memory) or Error(device).
class Horizons {
 public:
  /// `which` of `azimuths` equal parts of the turn are looked at, 0 ... azimuths - 1; empty: all. Throws what
  /// require_azimuths() and require_valid(curve) throw.
  Horizons(const ocl::Device& device, const HeightField& field, int azimuths, std::vector<int> which = {},
           const EarthCurve& curve = {});

  int azimuths() const { return azimuths_; }
  const std::vector<int>& which() const { return which_; }
  const HeightField& field() const { return *field_; }
  /// Rows that a band has at most, so that it takes little memory: a power of 2 from 16 on.
  int band_rows() const { return band_rows_; }
  /// The map's rows, band by band.
  std::vector<RowBand> bands() const;
  /// From one row of the band to the next, in posts: a multiple of the widest vector.
  int stride() const { return stride_; }
  /// Work-items for the band's posts, LANES columns each.
  ocl::LaunchShape shape_of_posts(int rows) const;
  int lanes() const { return rays_.lanes; }

  /// Throws Error(bad_usage) for rows that the map, or a band, does not have.
  void at(const RowBand& band);
  /// Of the last band, [which][rows][stride].
  const ocl::Buffer<float>& rises() const { return rises_; }
  /// Unit vectors of `which`: east and south.
  const ocl::Buffer<float>& directions() const { return directions_; }
  /// Reads the horizons of the last band in one of `which`, [rows][columns].
  void read(std::size_t number, std::span<float> rises) const;

 private:
  const HeightField* field_;
  int azimuths_, stride_, band_rows_;
  std::vector<int> which_;
  double bend_perm_;
  RowBand band_;
  ocl::KernelTuning rays_;
  ocl::Kernel kernel_;
  ocl::Buffer<float> directions_, rises_;
};

/// Reads a buffer [rows][stride] into [rows][columns].
template <class T>
void read_band(const ocl::Buffer<T>& buffer, const RowBand& band, int stride, int columns,
               std::span<T> values, std::size_t first = 0) {
  std::vector<T> padded(static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(stride));
  buffer.read(padded, first);
  for (int row = 0; row < band.rows; ++row) {
    const auto from = padded.begin() + static_cast<std::ptrdiff_t>(row) * stride;
    std::copy(from, from + columns, values.begin() + static_cast<std::ptrdiff_t>(row) * columns);
  }
}

}  // namespace offing::terrain
