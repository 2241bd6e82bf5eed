#include "tests/ocl/shared_layout.h"

#include <cstdint>

#include "host/ocl/buffer.h"
#include "host/ocl/program.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

namespace offing::test {

std::vector<std::size_t> device_layout(const ocl::Device& device, const std::string& header,
                                       const std::string& type, const std::vector<std::string>& members) {
  std::string source = "#include \"" + header + "\"\nkernel void layout(global uint* bytes) {\n  " + type +
                       " value;\n  bytes[0] = sizeof value;\n";
  for (std::size_t i = 0; i < members.size(); ++i) {
    source += "  bytes[" + std::to_string(i + 1) + "] = (uint)((char*)&value." + members[i] +
              " - (char*)&value);\n";
  }
  const TestKernels kernels;
  const ScopedEnvironment uncached("OFFING_CACHE_DIR", "");  // a program for this once
  kernels.write("layout.cl", source + "}\n");
  const ocl::Buffer<std::uint32_t> bytes(device, members.size() + 1, "layout");
  ocl::Program::build(device, "layout.cl").kernel("layout").launch({{1}}, bytes);
  const std::vector<std::uint32_t> values = bytes.read();
  return {values.begin(), values.end()};
}

}  // namespace offing::test
