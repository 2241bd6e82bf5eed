// The header of a tile store, store.toml.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/io/tile_store/tile_store.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  static const offing::fuzz::InputFile file("store.toml");
  file.hold({data, size});
  return offing::fuzz::check_reading([] {
    const offing::TileStoreHeader header = offing::TileStore(file.folder()).header();
    expect(header.shape.columns >= 2 && header.shape.rows >= 2 && header.shape.levels >= 1);
    expect(header.spacing_x_m > 0.0 && header.spacing_z_m > 0.0 && header.lowest_m <= header.highest_m);
    expect(std::isfinite(header.lowest_m) && std::isfinite(header.highest_m));
    const offing::Georeference& place = header.georeference;
    for (const double number : {header.spacing_x_m, header.spacing_z_m, place.origin_x, place.origin_y,
                                place.step_x, place.step_y}) {
      expect(std::isfinite(number));
    }
  });
}
