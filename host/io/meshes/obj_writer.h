#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "host/io/atomic_file.h"

namespace offing::meshes {

/// Writes a Wavefront OBJ, atomically: vertices, normals, then triangles, then commit(). Each number reads
/// back to the same float or double. Throws Error(file) if it cannot be written.
class ObjWriter {
 public:
  ObjWriter(const std::filesystem::path& path, std::string_view comment,
            Existing existing = Existing::replace)
      : file_(path, existing) {
    file_.write(fmt::format("# {}\n", comment));
  }

  /// A statement `v` or `vn`.
  template <typename Number>
  void put_vector(std::string_view keyword, const glm::tvec3<Number>& vector) {
    fmt::format_to(std::back_inserter(text_), "{} {} {} {}\n", keyword, vector.x, vector.y, vector.z);
    flush_if_long();
  }

  /// Whether a corner has a normal, of the index of its vertex.
  enum class Normals { none, same_index };

  void put_triangle(const std::array<std::uint32_t, 3>& corners, Normals normals) {
    const auto [a, b, c] = corners;
    const auto out = std::back_inserter(text_);
    if (normals == Normals::none) {
      fmt::format_to(out, "f {} {} {}\n", a + std::uint64_t{1}, b + std::uint64_t{1}, c + std::uint64_t{1});
    } else {
      fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", a + std::uint64_t{1}, b + std::uint64_t{1},
                     c + std::uint64_t{1});
    }
    flush_if_long();
  }

  void commit() {
    file_.write(text_);
    file_.commit();
  }

 private:
  void flush_if_long() {
    constexpr std::size_t long_text = 1 << 16;
    if (text_.size() < long_text) return;
    file_.write(text_);
    text_.clear();
  }

  AtomicFile file_;
  std::string text_;
};

}  // namespace offing::meshes
