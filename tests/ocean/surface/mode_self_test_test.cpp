// Which faults of a device the self-tests of the sea find: kernels with a fault stand for its compiler. At
// 16, where only the group family can do a transform.
#include "host/ocean/surface/mode_self_test.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocean/surface/velocity_map.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/log_capture.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocean {
namespace {

class ModeSelfTestTest : public testing::Test {
 protected:
  void make(const ModeTransform::Request& request) {
    const std::vector<Cascade> cascades = cascades_from_patches(std::vector{90.0}, 16);
    const WaveModes modes(device_, make_sea_spectrum(SpectrumParameters{}), cascades, 16, {});
    ModeTransform(device_, modes, request);
  }

  test::TestKernels kernels_;
  test::LogCapture log_;
  ocl::Device device_ = ocl::Device::open();
};

// Fails if values of another work-item pass, as Intel's compiler gave them: only in kernels of several
// fields, so that no test of a plain transform would notice.
TEST_F(ModeSelfTestTest, FindsWrongFields) {
  kernels_.change("fft/rows.clh", "re[field] = all_re[field][q];",
                  "re[field] = field == 1 && thread == 0 ? all_re[0][q] : all_re[field][q];");
  for (const auto& request : {surface_request(), velocity_request()}) {
    test::expect_error(ErrorKind::device, ": workgroup transforms of size 16", [&] { make(request); });
  }
}

// Fails if an author who edits the sea's kernels is told that the device is broken.
TEST_F(ModeSelfTestTest, LeavesEditedSeasAlone) {
  kernels_.change("ocean/surface_assemble.cl", "-kx * chop_im, kx * chop_re",
                  "-2.0f * kx * chop_im, kx * chop_re");
  make(surface_request());
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
}

}  // namespace
}  // namespace offing::ocean
