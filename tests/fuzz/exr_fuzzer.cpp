#include <cstddef>
#include <cstdint>
#include <span>

#include "host/io/exr_image.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("frame.exr");
  file.hold({data, size});
  offing::fuzz::check_reading([] { offing::read_exr_attributes(file.path()); });
  return offing::fuzz::check_reading([] {
    const offing::ExrContent content = offing::read_exr(file.path());
    expect(content.width > 0 && content.height > 0);
    const auto pixels = static_cast<std::size_t>(content.width) * static_cast<std::size_t>(content.height);
    for (const auto& channel : content.channels) expect(channel.values.size() == pixels);
  });
}
