#include "host/terrain/analysis/sky_view.h"

#include <cstddef>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {

SkyView::SkyView(const ocl::Device& device, const Horizons& horizons)
    : horizons_(&horizons),
      kernel_(
          ocl::Program::build(device, "terrain/sky_view.cl", ocl::Defines().set("LANES", horizons.lanes()))
              .kernel("sky_view")),
      factors_(device,
               static_cast<std::size_t>(horizons.stride()) * static_cast<std::size_t>(horizons.band_rows()),
               "sky-view factors") {
  if (static_cast<int>(horizons.which().size()) != horizons.azimuths()) {
    throw Error(ErrorKind::bad_usage, "sky view: expected horizons in all azimuths", "leave `which` empty");
  }
}

void SkyView::read(const RowBand& band, std::span<float> factors) {
  const HeightField& field = horizons_->field();
  const int columns = field.grid().columns;
  require_room("sky-view factors", static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(columns),
               factors.size());
  kernel_.launch(horizons_->shape_of_posts(band.rows), field.heights_m(),
                 field.device_field(CastMethod::parity), horizons_->directions(), horizons_->rises(),
                 horizons_->azimuths(), band.first_row, band.rows, horizons_->stride(), factors_);
  read_band(factors_, band, horizons_->stride(), columns, factors);
}

}  // namespace offing::terrain
