#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/ocean.h"

namespace offing::ocean {
namespace {

// Fails if the copy of a field on the device differs from the field on the host: of the second cascade, so
// that it begins at the wrong texel or is of another component.
TEST(FieldCopyTest, IsTheFieldOnTheHost) {
  const ocl::Device device = ocl::Device::open();
  const SeaSpectrum spectrum = make_sea_spectrum({});
  Ocean sea(device, spectrum, {.size = 32, .cascades = choose_cascades(spectrum, 32, 2)});
  ASSERT_EQ(sea.parameters().cascades.size(), 2u);
  sea.at(4.0);
  const SurfaceFields fields = sea.read_surface(1);
  const std::vector<const std::vector<float>*> all{&fields.displacement_x, &fields.displacement_y,
                                                   &fields.displacement_z, &fields.slope_x,
                                                   &fields.slope_z,        &fields.gradient_xx,
                                                   &fields.gradient_xz,    &fields.gradient_zz,
                                                   &fields.jacobian,       &fields.jacobian_min_eigenvalue};
  ocl::Buffer<float> values(device, 32 * 32 + 1, "values");
  for (std::size_t i = 0; i < all.size(); ++i) {
    sea.copy_field(1, static_cast<SeaField>(i), values, 1);
    const std::vector<float> copied = values.read();
    EXPECT_TRUE(std::equal(all[i]->begin(), all[i]->end(), copied.begin() + 1)) << i;
  }
  EXPECT_THROW(sea.copy_field(1, SeaField::slope_x, values, 2), Error);
  EXPECT_THROW(sea.read_fields(0, std::vector{SeaField::slope_x}, {}), Error);
}

}  // namespace
}  // namespace offing::ocean
