#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {

/// Level ground 41 x 21 posts, 10 m apart, with a wall 20 m high along column 30 and a void in a corner.
class WalledMapTest : public ::testing::Test {
 protected:
  WalledMapTest() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 41\nnrows 21\nxllcorner 5000\nyllcorner 700\ncellsize 10\nnodata_value -9\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 41; ++column) {
        grid << (row == 20 && column == 0 ? -9 : column == 30 ? 20 : 0) << ' ';
      }
      grid << "\n";
    }
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  /// A band of a raster, from a copy without its units: height maps are read in metres or feet alone.
  HeightMap band(const std::string& name, int number) const {
    std::ifstream file(path(name), std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string unit = "role=\"unittype\"";
    for (auto at = bytes.find(unit); at != std::string::npos; at = bytes.find(unit)) bytes[at + 6] = 'n';
    std::ofstream(path("plain.tif"), std::ios::binary) << bytes;
    HeightMapOptions options;
    options.horizontal_unit = HorizontalUnit::metre;
    options.band = number;
    return read_height_map(path("plain.tif"), options).map;
  }
  /// Whether a raster says this of a band: GDAL keeps units and descriptions as text.
  bool has_text(const std::string& name, const std::string& text) const {
    std::ifstream file(path(name), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    return bytes.find(text) != std::string::npos;
  }

  TemporaryFolder folder_;
};

}  // namespace offing::test
