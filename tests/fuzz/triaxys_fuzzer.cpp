#include <cstddef>
#include <cstdint>

#include "host/io/spectra/triaxys_spectra.h"
#include "tests/fuzz/spectrum_fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  return offing::fuzz::check_reader([&] { return offing::spectra::parse_triaxys(text, "fuzz"); });
}
