// What an Ocean shows after the device refused memory half-way through foam.
//
// The program's own clCreateBuffer() comes before the library's and passes calls on, save the one that is to
// fail.
#include <limits>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/opencl.h"
#include "tests/ocl/expect_error.h"

namespace {
int buffers_until_failure = std::numeric_limits<int>::max();
}

extern "C" cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, std::size_t bytes, void* host,
                                 cl_int* status) {
  if (--buffers_until_failure == 0) {
    *status = CL_MEM_OBJECT_ALLOCATION_FAILURE;
    return nullptr;
  }
  using Create = decltype(&clCreateBuffer);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "clCreateBuffer"));
  return create(context, flags, bytes, host, status);
}

namespace offing::ocean {
namespace {

// Fails if an Ocean whose foam ran out of memory shows the surface of a past instant as that of its time, or
// never has foam again. Buffer 1 is the foam, 2 the coverage now, later ones those of the past, for which the
// surface maps have moved there.
TEST(FailingFoam, LeavesTheSurfaceOfItsTime) {
  const ocl::Device device = ocl::Device::open();
  const SeaSpectrum spectrum = make_sea_spectrum({});
  const OceanParameters parameters{.size = 16,
                                   .cascades = cascades_from_patches(std::vector{80.0, 15.0}, 16),
                                   .foam = {.onset_jacobian = 1.0}};
  Ocean fresh(device, spectrum, parameters);
  fresh.at(3.1);
  const std::vector<float> surface = fresh.read_surface(1).displacement_y;
  const std::vector<float> composed = fresh.read_composed({.columns = 4, .rows = 4}).slope_x;
  const std::vector<float> foam = fresh.read_foam(0);
  for (const int failing : {1, 2, 4}) {
    Ocean ocean(device, spectrum, parameters);
    ocean.at(3.1);
    buffers_until_failure = failing;
    test::expect_error(ErrorKind::out_of_memory, "foam", [&] { ocean.read_foam(0); });
    buffers_until_failure = std::numeric_limits<int>::max();
    EXPECT_EQ(ocean.read_surface(1).displacement_y, surface) << failing;
    EXPECT_EQ(ocean.read_composed({.columns = 4, .rows = 4}).slope_x, composed) << failing;
    EXPECT_EQ(ocean.read_foam(0), foam) << failing;
    EXPECT_EQ(ocean.read_surface(1).displacement_y, surface) << failing;
  }
}

}  // namespace
}  // namespace offing::ocean
