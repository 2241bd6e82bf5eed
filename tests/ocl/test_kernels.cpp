#include "tests/ocl/test_kernels.h"

#include <fstream>

namespace offing::test {

TestKernels::TestKernels()
    : kernel_path_("OFFING_KERNEL_PATH", folder_.path().string()),
      cache_path_("OFFING_CACHE_DIR", cache_.path().string()) {}

void TestKernels::write(std::string_view name, std::string_view text) const {
  std::filesystem::create_directories((folder_.path() / name).parent_path());
  std::ofstream(folder_.path() / name) << text;
}

}  // namespace offing::test
