#include "host/ocean/query/query_maps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "host/ocean/query/query_error.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/mode_self_test.h"

namespace offing::ocean {
namespace {

constexpr int smallest_map = 64;  // from here on there are kernels for vectors

// A Gaussian field goes beyond once in 1e15 samples; a texel at the limit is off by what goes beyond.
constexpr double standard_deviations = 8.0;

std::vector<float> filter_of(const WaveModes& modes, int size) {
  // Rows and columns beyond the transform carry nothing, and vectors read beyond the last column.
  const int read = std::max(size / 2, modes.columns()) + ocl::widest_lanes;
  const AxisResponse response = spline_response(QUERY_TAPS, size, std::min(modes.size(), size) / 2);
  std::vector<float> filter(static_cast<std::size_t>(read), 0.0f);
  std::transform(response.filter.begin(), response.filter.end(), filter.begin(),
                 [](double value) { return static_cast<float>(value); });
  return filter;
}

FilteredVariance filtered_variance(std::span<const float> variance, int modes,
                                   std::span<const double> filter) {
  const auto bins = static_cast<std::size_t>(std::ceil(modes / std::numbers::sqrt2)) + 2;
  FilteredVariance sums{std::vector<double>(bins), std::vector<double>(bins), std::vector<double>(bins)};
  const auto last = static_cast<int>(filter.size()) - 1;
  for (int row = -modes / 2 + 1; row < modes / 2; ++row) {
    for (int column = -modes / 2 + 1; column < modes / 2; ++column) {
      const double own_m2 =
          variance[static_cast<std::size_t>((row & (modes - 1)) * modes + (column & (modes - 1)))];
      if (own_m2 == 0.0 || std::abs(row) > last || std::abs(column) > last) continue;
      const double cycles2 = 1.0 * row * row + 1.0 * column * column;
      const double factor = filter[static_cast<std::size_t>(std::abs(row))] *
                            filter[static_cast<std::size_t>(std::abs(column))];
      const double filtered_m2 = own_m2 * factor * factor;
      const auto bin = static_cast<std::size_t>(std::lround(std::sqrt(cycles2)));
      sums.heights_m2[bin] += filtered_m2;
      sums.along_x_m2[bin] += filtered_m2 * column * column / cycles2;
      sums.along_z_m2[bin] += filtered_m2 * row * row / cycles2;
    }
  }
  return sums;
}

}  // namespace

ModeTransform::Request query_map_request(int map_fields, int mode_rows) {
  return {.first_source = "ocean/query_map_columns.cl",
          .first_kernel = "query_map_columns",
          .second_source = "ocean/query_map_rows.cl",
          .second_kernel = "query_map_rows",
          .half_fields = map_fields,
          .pair_fields = map_fields / 2,
          .mode_rows = mode_rows,
          .self_test = query_map_self_test};
}

int query_map_size(double most_cycles) {
  const auto wanted = static_cast<unsigned>(std::ceil(4.0 * std::max(most_cycles, 1.0)));
  return std::clamp(static_cast<int>(std::bit_ceil(wanted)), smallest_map, largest_size);
}

QueryMaps::QueryMaps(const ocl::Device& device, const WaveModes& modes, std::span<const Cascade> cascades,
                     int size, int map_fields)
    : cascades_(cascades),
      transform_(device,
                 {.size = size,
                  .columns = std::min(modes.columns(), size / 2),
                  .cascade_count = modes.cascade_count()},
                 query_map_request(map_fields, modes.size())),
      scales_(cascades.size() * QUERY_MAP_FIELDS),
      filter_(device, filter_of(modes, size), "filter of maps for queries"),
      inverse_scales_(device, scales_.size(), "scales of maps for queries"),
      map_(device,
           cascades.size() * static_cast<std::size_t>(size) *
               static_cast<std::size_t>(size + QUERY_MAP_HALO) * static_cast<std::size_t>(map_fields / 2),
           "map for queries") {
  const AxisResponse response = spline_response(QUERY_TAPS, size, std::min(modes.size(), size) / 2);
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    variances_.push_back(
        filtered_variance(modes.variance(static_cast<int>(i)), modes.size(), response.filter));
  }
}

void QueryMaps::set_scales(const WaveModes& modes, const ModeFields::Place& place, const Sea& sea) {
  const bool is_same =
      scaled_ && scaled_->depth_m == place.depth_m && scaled_->min_wavelength_m == place.min_wavelength_m;
  if (is_same) return;
  const double most_radpm = largest_wavenumber_radpm(place.min_wavelength_m);
  std::vector<float> inverse;
  for (std::size_t i = 0; i < cascades_.size(); ++i) {
    const double step_radpm = 2.0 * std::numbers::pi / cascades_[i].patch_length_m;
    const FilteredVariance& variance = variances_[i];
    std::array<double, QUERY_MAP_FIELDS> squares{};
    for (std::size_t bin = 1; bin < variance.heights_m2.size(); ++bin) {
      const double k = step_radpm * static_cast<double>(bin), height_m2 = variance.heights_m2[bin];
      if (height_m2 == 0.0 || k > most_radpm + step_radpm) continue;
      squares[0] += sea.choppiness * sea.choppiness * variance.along_x_m2[bin];
      squares[1] += sea.choppiness * sea.choppiness * variance.along_z_m2[bin];
      squares[2] += height_m2;
      if (!place.depth_m) continue;
      // As ocean/mode_fields.cl has them.
      const double omega = modes.clock().rate(sea.dispersion.omega_radps(k)) * modes.clock().radps_per_rate();
      const double bed_m = sea.dispersion.depth_m, depth_m = *place.depth_m;
      const double above_bed = std::exp(-2.0 * k * (bed_m - depth_m)), at_bed = std::exp(-2.0 * k * bed_m);
      const double attenuation = std::exp(-k * depth_m), decay = omega * attenuation / (1.0 - at_bed);
      const double up = decay * (1.0 - above_bed), along = decay * (1.0 + above_bed) / k;
      const double head = attenuation * (1.0 + above_bed) / (1.0 + at_bed);
      squares[3] += up * up * height_m2;
      squares[4] += head * head * height_m2;
      squares[5] += along * along * height_m2;
      squares[6] += omega * omega * along * along * height_m2;
      squares[7] += omega * omega * up * up * height_m2;
    }
    for (std::size_t field = 0; field < squares.size(); ++field) {
      const double scale = standard_deviations * std::sqrt(squares[field]) / QUERY_MAP_LARGEST;
      // Derivatives come in cycles, of a field in metres times metres.
      const double unit = field < 2 ? step_radpm : 1.0;
      scales_[i * QUERY_MAP_FIELDS + field] = static_cast<float>(scale);
      inverse.push_back(scale > 1e-30 ? static_cast<float>(unit / scale) : 0.0f);
    }
  }
  inverse_scales_.write(inverse);
  scaled_ = place;
}

void QueryMaps::at(const WaveModes& modes, ModeFields& fields, const ModeFields::Place& place,
                   const Sea& sea) {
  if (held_ && held_->covers(place)) return;
  held_.reset();
  fields.at(modes, place);
  set_scales(modes, place, sea);
  transform_.advance(fields.fields(), filter_);
  transform_.assemble(inverse_scales_, map_);
  held_ = place;
}

}  // namespace offing::ocean
