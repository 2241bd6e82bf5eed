#include <cstddef>
#include <cstdint>

#include "host/io/meshes/stl_mesh.h"
#include "tests/fuzz/mesh_fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  return offing::fuzz::check_mesh_reader([&] { return offing::meshes::parse_stl(bytes, "fuzz"); });
}
