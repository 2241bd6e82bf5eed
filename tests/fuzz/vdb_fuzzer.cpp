#include <cstddef>
#include <cstdint>

#include "host/io/vdb/vdb_volume.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

/// OpenVDB loses the nodes of a tree whose reading throws half-way: looking for leaks would take most of the
/// time. Blocks that were given back, of which each run has 1 MB, are kept for fewer runs.
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0:quarantine_size_mb=8";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("cloud.vdb");
  file.hold({data, size});
  return offing::fuzz::check_reading([] {
    // Small volumes alone: filling 2 GiB with one value takes seconds.
    const offing::VdbCloud cloud = offing::read_vdb(file.path(), "density", {.bricks = 512, .places = 4096});
    offing::require_valid(cloud.volume);
    expect(cloud.albedo.empty() || cloud.albedo.size() == cloud.volume.density.size());
    for (const auto& colour : cloud.albedo) {
      for (const float share : colour) expect(share >= 0.0f && share <= 1.0f);
    }
  });
}
