#include "tests/ocl/test_kernels.h"

#include <fstream>

#include <gtest/gtest.h>

#include "kernels/kernel_sources.h"

namespace offing::test {

TestKernels::TestKernels()
    : kernel_path_("OFFING_KERNEL_PATH", folder_.path().string()),
      cache_path_("OFFING_CACHE_DIR", cache_.path().string()) {}

void TestKernels::write(std::string_view name, std::string_view text) const {
  std::filesystem::create_directories((folder_.path() / name).parent_path());
  std::ofstream(folder_.path() / name) << text;
}

void TestKernels::change(std::string_view name, std::string_view part, std::string_view by) const {
  for (const kernels::KernelSource& source : kernels::kernel_sources()) {
    if (source.name != name) continue;
    std::string text(source.text);
    const std::size_t place = text.find(part);
    if (place == std::string::npos) break;
    return write(name, text.replace(place, part.size(), by));
  }
  ADD_FAILURE() << name << " has no \"" << part << "\"";
}

}  // namespace offing::test
