// The input holds up to five files, set apart by the byte 0x1d: densities, alpha1, alpha2, r1, r2.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/io/spectra/ndbc_spectra.h"
#include "tests/fuzz/spectrum_fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::spectra::NamedText;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  std::array<std::optional<NamedText>, 5> files;
  for (auto& file : files) {
    const std::size_t end = rest.find('\x1d');
    file = NamedText{rest.substr(0, end), "41010w2020.txt"};
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return offing::fuzz::check_reader([&] {
    return offing::spectra::parse_ndbc(files[0]->text, files[0]->file_name,
                                       {files[1], files[2], files[3], files[4]});
  });
}
