#include "host/io/meshes/ply_writer.h"

#include <bit>
#include <iterator>

#include <fmt/format.h>

namespace offing::meshes {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

PlyWriter::PlyWriter(const std::filesystem::path& path, const std::vector<std::string>& comments,
                     const std::vector<PlyColumn>& columns, const Counts& counts, Existing existing)
    : file_(path, existing) {
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  const auto out = std::back_inserter(header);
  for (const std::string& comment : comments) fmt::format_to(out, "comment {}\n", comment);
  fmt::format_to(out, "element vertex {}\n", counts.vertices);
  for (const PlyColumn& column : columns) fmt::format_to(out, "property {} {}\n", column.type, column.name);
  // Readers hold vertex numbers in 32-bit signed integers, but for those that are larger.
  fmt::format_to(out, "element face {}\nproperty list uchar {} vertex_indices\nend_header\n", counts.faces,
                 counts.vertices > INT32_MAX ? "uint" : "int");
  file_.write(header);
}

void PlyWriter::put_triangle(const std::array<std::uint32_t, 3>& corners) {
  constexpr char corner_count = 3;
  file_.write(&corner_count, 1);
  file_.write(corners.data(), sizeof(corners));
}

}  // namespace offing::meshes
