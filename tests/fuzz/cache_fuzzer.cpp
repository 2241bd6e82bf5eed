// Entries of the cache of compiled kernels. The input is a file; where its first byte is even, a binary that
// store() has written, in which one byte is then changed. What load() returns goes to a driver, so that it
// must be what was stored.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <spdlog/spdlog.h>

#include "host/ocl/disk_cache.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

namespace {

constexpr const char* identity = "fuzz";

std::vector<std::uint8_t> content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);  // each damaged entry is a warning
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  if (size < 4) return -1;  // do not keep it
  static const offing::fuzz::InputFile entry(
      offing::ocl::DiskCache().entry_path(identity).filename().string());
  static const offing::ocl::DiskCache cache(entry.folder());
  if (data[0] % 2 == 1) {
    entry.hold({data + 1, size - 1});
    const auto found = cache.load(identity);
    expect(!found || !found->empty());
    return 0;
  }
  const std::vector<std::uint8_t> binary(data + 3, data + size);
  cache.store(identity, binary);
  expect(cache.load(identity) == binary);
  std::vector<std::uint8_t> bytes = content_of(entry.path());
  const std::size_t place = (data[1] + 256u * data[2]) % bytes.size();
  bytes[place] = static_cast<std::uint8_t>(bytes[place] ^ (1u << data[0] / 2 % 8));
  entry.hold(bytes);
  expect(!cache.load(identity));  // one changed bit is always found
  return 0;
}
