#include "host/terrain/shading/open_sky.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/ocl/disk_cache.h"
#include "host/ocl/program.h"
#include "host/ocl/self_test.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

constexpr long long most_shares = 1'100'000;
// Fewer are made as fast as they are read. So are all where heights would have to be read back for their key.
constexpr std::size_t least_kept_shares = 1 << 16;
constexpr ocl::CacheKind sky_maps{"sky", "sky map", 256'000'000};

int count_of(int posts, int stride) {
  return (posts - 1 + stride - 1) / stride + 1;
}

/// All that shapes the shares.
std::string identity_of_shares(const ocl::Device& device, const HeightField& field,
                               const ocl::ProgramRecipe& program, int stride) {
  const auto heights_m = field.heights_m().map();
  const TerrainField layout = field.device_field(CastMethod::parity);
  const std::array<ocl::ProgramRecipe, 3> programs{
      {program, {"terrain/pyramid_base.cl", {}}, {"terrain/pyramid_reduce.cl", {}}}};
  return ocl::identity_of(device.info(), programs) +
         ocl::joined_identity({ocl::identity_of_bytes(std::as_bytes(heights_m.span())),
                               ocl::identity_of_bytes(std::as_bytes(std::span(&layout, 1))),
                               std::to_string(stride)});
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
  const ocl::ProgramRecipe program{
      "terrain/open_sky.cl", ocl::Defines().set("LANES", rays.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT)};
  const ocl::DiskCache cache(ocl::DiskCache::default_folder(), sky_maps);
  const bool is_kept =
      cache.is_on() && shares_.size() >= least_kept_shares && device.info().has_host_unified_memory;
  const std::string identity = is_kept ? identity_of_shares(device, field, program, stride_) : std::string();
  if (is_kept) {
    const std::optional<std::vector<std::uint8_t>> kept = cache.load(identity);
    if (kept && kept->size() == shares_.size()) {
      shares_.write(*kept);
      return;
    }
  }
  ocl::Program::build(device, program.source_name, program.defines)
      .kernel("open_sky")
      .launch(ocl::launch_shape(rays, static_cast<std::size_t>(columns_), static_cast<std::size_t>(rows_)),
              field.heights_m(), field.pyramid().maxima_m(), field.device_field(CastMethod::parity), stride_,
              columns_, shares_);
  if (is_kept) cache.store(identity, shares_.read());
}

void OpenSky::describe(TerrainLook& look) const {
  look.open_sky_stride = stride_;
  look.open_sky_columns = columns_;
  look.open_sky_rows = rows_;
}

}  // namespace offing::terrain
