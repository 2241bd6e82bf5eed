#include <cstddef>
#include <cstdint>

#include "host/io/png_image.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("picture.png");
  file.hold({data, size});
  offing::fuzz::check_reading([] {
    const offing::RgbImage image = offing::read_png(file.path());
    expect(image.width > 0 && image.height > 0);
    expect(image.rgb.size() ==
           std::size_t{3} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height));
  });
  return offing::fuzz::check_reading([] {
    const offing::RgbaImage image = offing::read_png_with_alpha(file.path());
    expect(image.width > 0 && image.height > 0);
    expect(image.rgba.size() ==
           std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height));
  });
}
