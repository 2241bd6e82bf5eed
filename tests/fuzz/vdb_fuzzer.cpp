#include <cstddef>
#include <cstdint>

#include "host/io/vdb/vdb_volume.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

/// OpenVDB loses the nodes of a tree whose reading throws half-way.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libopenvdb.so\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("cloud.vdb");
  file.hold({data, size});
  return offing::fuzz::check_reading([] {
    const offing::VdbCloud cloud = offing::read_vdb(file.path());
    offing::require_valid(cloud.volume);
    expect(cloud.albedo.empty() || cloud.albedo.size() == cloud.volume.density.size());
    for (const auto& colour : cloud.albedo) {
      for (const float share : colour) expect(share >= 0.0f && share <= 1.0f);
    }
  });
}
