#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "host/io/atomic_file.h"

namespace offing {

/// Writes heights as a GeoTIFF of floats, row by row, whole or not at all: of a map whose posts are so many
/// metres apart, and which lies nowhere in the world.
class HeightRasterWriter {
 public:
  /// Throws Error(file) if it cannot be written.
  HeightRasterWriter(const std::filesystem::path& path, int columns, int rows, double spacing_m,
                     Existing existing = Existing::replace);
  ~HeightRasterWriter();
  HeightRasterWriter(const HeightRasterWriter&) = delete;
  HeightRasterWriter& operator=(const HeightRasterWriter&) = delete;

  /// Whole rows, from north to south. Throws Error(file).
  void add_rows(std::span<const float> heights_m);
  /// Publishes the file under its name. Throws Error(file).
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing
