// Height maps and pictures of the ground, as GDAL reads them. The library itself is not instrumented: what
// the sanitizers see of it is memory that it allocates.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/io/height_maps/read_colour_map.h"
#include "host/io/height_maps/read_height_map.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

namespace {

using offing::HeightMap;
using offing::fuzz::expect;

void expect_contract(const HeightMap& map) {
  expect(map.columns >= 2 && map.rows >= 2);
  expect(std::isfinite(map.spacing_x_m) && map.spacing_x_m > 0.0);
  expect(std::isfinite(map.spacing_z_m) && map.spacing_z_m > 0.0);
  const auto posts = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  expect(map.heights_m.size() == posts && (map.is_void.empty() || map.is_void.size() == posts));
  for (const float height_m : map.heights_m) expect(std::isfinite(height_m));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const offing::fuzz::InputFile file("map.tif");
  file.hold({data, size});
  offing::fuzz::check_reading([] { expect_contract(offing::read_height_map(file.path()).map); });
  return offing::fuzz::check_reading([] {
    const HeightMap terrain{
        .columns = 4, .rows = 3, .heights_m = std::vector<float>(12), .is_void = {}, .georeference = {}};
    const offing::ColourMap colours = offing::read_colour_map(file.path(), terrain);
    expect(colours.columns > 0 && colours.rows > 0);
    expect(colours.rgba.size() ==
           std::size_t{4} * static_cast<unsigned>(colours.columns) * static_cast<unsigned>(colours.rows));
  });
}
