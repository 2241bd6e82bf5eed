#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/io/atomic_file.h"

namespace offing::meshes {

/// A scalar property of vertices; `type` is float, double, uchar or uint.
struct PlyColumn {
  std::string_view type;
  std::string name;
};

/// Writes a binary little-endian PLY of triangles, atomically and with the same bytes for the same mesh: the
/// values of each vertex in the order of the columns, then the triangles, then commit(). Throws Error(file)
/// if it cannot be written.
class PlyWriter {
 public:
  /// How many rows will be written.
  struct Counts {
    std::size_t vertices, faces;
  };

  /// `comments` are lines without a line break.
  PlyWriter(const std::filesystem::path& path, const std::vector<std::string>& comments,
            const std::vector<PlyColumn>& columns, const Counts& counts,
            Existing existing = Existing::replace);

  /// Values of a vertex, of the type of their columns.
  void put(const float* values, std::size_t count) { file_.write(values, count * sizeof(float)); }
  void put(float value) { put(&value, 1); }
  void put(double value) { file_.write(&value, sizeof(value)); }
  void put(std::uint8_t value) { file_.write(&value, 1); }
  void put(std::uint32_t value) { file_.write(&value, sizeof(value)); }

  void put_triangle(const std::array<std::uint32_t, 3>& corners);
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

}  // namespace offing::meshes
