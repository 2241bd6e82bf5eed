#include "host/terrain/analysis/horizons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

/// Floats of the horizons of a band: 256 MiB, unless even the fewest rows of a map take more.
constexpr std::size_t most_floats = std::size_t{1} << 26;
constexpr int most_rows = 64, fewest_rows = 16;

/// East and south of azimuths; those along the axes exactly.
std::vector<float> directions_of(int azimuths, const std::vector<int>& which) {
  std::vector<float> directions;
  for (const int number : which) {
    const double azimuth_rad = 2.0 * std::numbers::pi * number / azimuths;
    const bool is_north_south = 2 * number % azimuths == 0, is_east_west = 4 * number % azimuths == 0;
    directions.push_back(is_north_south ? 0.0f : static_cast<float>(std::sin(azimuth_rad)));
    directions.push_back(is_east_west && !is_north_south ? 0.0f : static_cast<float>(-std::cos(azimuth_rad)));
  }
  return directions;
}

std::vector<int> all_unless_given(int azimuths, std::vector<int> which) {
  require_azimuths(azimuths);
  if (which.empty()) {
    which.resize(static_cast<std::size_t>(azimuths));
    std::iota(which.begin(), which.end(), 0);
  }
  return which;
}

}  // namespace

void require_azimuths(int azimuths) {
  if (azimuths >= fewest_azimuths && azimuths <= most_azimuths) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("azimuths: expected {} ... {}, found {}", fewest_azimuths, most_azimuths, azimuths),
              "64 are usual");
}

Horizons::Horizons(const ocl::Device& device, const HeightField& field, int azimuths, std::vector<int> which,
                   const EarthCurve& curve)
    : field_(&field),
      azimuths_(azimuths),
      which_(all_unless_given(azimuths, std::move(which))),
      bend_perm_(curve.bend_perm()),
      rays_(ray_tuning(device)) {
  require_valid(curve);
  constexpr int widest = ocl::widest_lanes;
  stride_ = (field.grid().columns + widest - 1) / widest * widest;
  const auto floats_a_row = static_cast<std::size_t>(stride_) * which_.size();
  band_rows_ = most_rows;
  while (band_rows_ > fewest_rows && static_cast<std::size_t>(band_rows_) * floats_a_row > most_floats) {
    band_rows_ /= 2;
  }
  ocl::Defines defines = ocl::Defines().set("LANES", rays_.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT);
  if (bend_perm_ != 0.0) defines.set_flag("IS_CURVED");
  kernel_ = ocl::Program::build(device, "terrain/horizons.cl", defines).kernel("horizons");
  directions_ = ocl::Buffer<float>(device, std::span<const float>(directions_of(azimuths_, which_)),
                                   "directions of horizons");
  const auto rows = static_cast<std::size_t>(std::min(band_rows_, field.grid().rows));
  rises_ = ocl::Buffer<float>(device, rows * floats_a_row, "horizons");
}

std::vector<RowBand> Horizons::bands() const {
  std::vector<RowBand> bands;
  const int rows = field_->grid().rows;
  for (int row = 0; row < rows; row += band_rows_) bands.push_back({row, std::min(band_rows_, rows - row)});
  return bands;
}

ocl::LaunchShape Horizons::shape_of_posts(int rows) const {
  const auto lanes = static_cast<std::size_t>(rays_.lanes);
  return {{static_cast<std::size_t>(stride_) / lanes, static_cast<std::size_t>(rows)}, {rays_.group}};
}

void Horizons::at(const RowBand& band) {
  if (band.first_row < 0 || band.rows < 1 || band.rows > band_rows_ ||
      band.first_row > field_->grid().rows - band.rows) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("horizons: expected at most {} of {} rows, found {} from row {} on", band_rows_,
                            field_->grid().rows, band.rows, band.first_row),
                "ask for rows of the map, some at a time");
  }
  band_ = band;
  ocl::LaunchShape shape = shape_of_posts(band.rows);
  shape.global[1] = which_.size();
  kernel_.launch(shape, field_->heights_m(), field_->pyramid().maxima_m(),
                 field_->device_field(CastMethod::parity), directions_, band.first_row, band.rows, stride_,
                 static_cast<float>(bend_perm_), rises_);
}

void Horizons::read(std::size_t number, std::span<float> rises) const {
  const std::size_t plane = static_cast<std::size_t>(band_.rows) * static_cast<std::size_t>(stride_);
  require_room("horizons",
               static_cast<std::size_t>(band_.rows) * static_cast<std::size_t>(field_->grid().columns),
               rises.size());
  read_band(rises_, band_, stride_, field_->grid().columns, rises, number * plane);
}

}  // namespace offing::terrain
