#include "host/terrain/analysis/sun_hours.h"

#include <cstddef>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

int moments_of(const SunsOfBand& suns) {
  return static_cast<int>(suns.suns.size() / suns.blocks.size());
}

std::size_t posts_of_band(const RowBand& band, int columns) {
  return static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(columns);
}

void require_fit(const Horizons& horizons, const SunsOfBand& suns) {
  const int columns = horizons.field().grid().columns;
  const bool has_blocks = suns.block_columns > 0 && suns.block_columns % ocl::widest_lanes == 0 &&
                          std::ssize(suns.blocks) == (columns - 1) / suns.block_columns + 1;
  bool is_fit = has_blocks && suns.suns.size() % suns.blocks.size() == 0;
  const int count = static_cast<int>(horizons.which().size());
  for (const BlockSun& sun : suns.suns) {
    is_fit = is_fit && sun.horizon >= 0 && sun.horizon < count && sun.next >= 0 && sun.next < count;
  }
  if (is_fit) return;
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("sun hours: expected suns for {} columns and {} horizons, found {} suns for {} blocks "
                  "of {} columns",
                  columns, count, suns.suns.size(), suns.blocks.size(), suns.block_columns),
      "give each block of columns as many suns, of horizons that were made");
}

}  // namespace

SunHours::SunHours(const ocl::Device& device, const Horizons& horizons)
    : device_(device), horizons_(&horizons) {
  const ocl::Defines lanes = ocl::Defines().set("LANES", horizons.lanes());
  ocl::Defines with_azimuths = lanes;
  with_azimuths.set("AZIMUTHS", horizons.azimuths());
  hours_kernel_ = ocl::Program::build(device, "terrain/sun_hours.cl", with_azimuths).kernel("sun_hours");
  mask_kernel_ = ocl::Program::build(device, "terrain/sun_mask.cl", lanes).kernel("sun_mask");
  const auto posts =
      static_cast<std::size_t>(horizons.stride()) * static_cast<std::size_t>(horizons.band_rows());
  hours_ = ocl::Buffer<float>(device, posts, "hours of sun");
  energy_ = ocl::Buffer<float>(device, posts, "sunlight");
  lit_ = ocl::Buffer<std::uint8_t>(device, posts, "sun mask");
}

void SunHours::read(const RowBand& band, const SunsOfBand& suns, std::span<float> hours,
                    std::span<float> energy_kwh) {
  require_fit(*horizons_, suns);
  const HeightField& field = horizons_->field();
  const int columns = field.grid().columns;
  require_room("hours of sun", posts_of_band(band, columns), hours.size());
  require_room("sunlight", posts_of_band(band, columns), energy_kwh.size());
  if (blocks_.size() != suns.blocks.size()) {
    blocks_ = ocl::Buffer<SunBlock>(device_, suns.blocks.size(), "blocks of suns");
  }
  if (suns_.size() != suns.suns.size()) suns_ = ocl::Buffer<BlockSun>(device_, suns.suns.size(), "suns");
  blocks_.write(suns.blocks);
  suns_.write(suns.suns);
  hours_kernel_.launch(horizons_->shape_of_posts(band.rows), field.heights_m(),
                       field.device_field(CastMethod::parity), horizons_->rises(),
                       static_cast<int>(horizons_->which().size()), blocks_, suns_, moments_of(suns),
                       suns.block_columns, band.first_row, band.rows, horizons_->stride(), hours_, energy_);
  read_band(hours_, band, horizons_->stride(), columns, hours);
  read_band(energy_, band, horizons_->stride(), columns, energy_kwh);
}

void SunHours::read_mask(const RowBand& band, const SunsOfBand& suns, int moment,
                         std::span<std::uint8_t> lit) {
  if (suns.suns.size() != suns_.size() || moment < 0 || moment >= moments_of(suns)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("sun mask: expected one of {} moments, found {}", moments_of(suns), moment),
                "read the hours of the band first");
  }
  const HeightField& field = horizons_->field();
  const int columns = field.grid().columns;
  require_room("sun mask", posts_of_band(band, columns), lit.size());
  mask_kernel_.launch(horizons_->shape_of_posts(band.rows), field.heights_m(),
                      field.device_field(CastMethod::parity), horizons_->rises(), blocks_, suns_,
                      moments_of(suns), moment, suns.block_columns, band.first_row, band.rows,
                      horizons_->stride(), lit_);
  read_band(lit_, band, horizons_->stride(), columns, lit);
}

}  // namespace offing::terrain
