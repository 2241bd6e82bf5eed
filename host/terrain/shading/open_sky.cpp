#include "host/terrain/shading/open_sky.h"

#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

constexpr long long most_shares = 1'100'000;

int count_of(int posts, int stride) {
  return (posts - 1 + stride - 1) / stride + 1;
}

}  // namespace

OpenSky::OpenSky(const ocl::Device& device, const HeightField& field) {
  const PostGrid& grid = field.grid();
  const auto shares_at = [&](int stride) {
    return static_cast<long long>(count_of(grid.columns, stride)) * count_of(grid.rows, stride);
  };
  while (shares_at(stride_) > most_shares) stride_ *= 2;
  columns_ = count_of(grid.columns, stride_);
  rows_ = count_of(grid.rows, stride_);
  shares_ = ocl::Buffer<std::uint8_t>(
      device, static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), "shares of the sky");
  const ocl::KernelTuning rays = ray_tuning(device);
  ocl::Program::build(device, "terrain/open_sky.cl",
                      ocl::Defines().set("LANES", rays.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT))
      .kernel("open_sky")
      .launch(ocl::launch_shape(rays, static_cast<std::size_t>(columns_), static_cast<std::size_t>(rows_)),
              field.heights_m(), field.pyramid().maxima_m(), field.device_field(CastMethod::parity), stride_,
              columns_, shares_);
}

void OpenSky::describe(TerrainLook& look) const {
  look.open_sky_stride = stride_;
  look.open_sky_columns = columns_;
  look.open_sky_rows = rows_;
}

}  // namespace offing::terrain
