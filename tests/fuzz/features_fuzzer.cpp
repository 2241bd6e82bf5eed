// Points and lines of GIS files, as --points takes them. The input's first byte chooses the format and the
// shape. The library itself is not instrumented: what the sanitizers see of it is memory that it allocates.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/io/height_maps/map_features.h"
#include "tests/fuzz/expect.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using offing::fuzz::expect;
  if (size == 0) return -1;  // do not keep it
  static const offing::fuzz::InputFile package("points.gpkg"), json("points.geojson");
  const offing::fuzz::InputFile& file = (data[0] & 1) != 0 ? package : json;
  const auto shape = (data[0] & 2) != 0 ? offing::FeatureShape::lines : offing::FeatureShape::points;
  file.hold({data + 1, size - 1});
  return offing::fuzz::check_reading([&] {
    const offing::FeatureTable table = offing::read_features(file.path(), shape, "");
    expect(table.count() > 0 && table.ends.size() == table.count() * offing::ends_of(shape));
    expect(table.values.size() == table.count() * table.columns.size());
    expect(table.place_of(table.count() - 1).find("feature") != std::string::npos);
    for (const glm::dvec3& end : table.ends) expect(std::isfinite(end.x) && std::isfinite(end.y));
  });
}
