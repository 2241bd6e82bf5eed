#pragma once

#include <cstddef>
#include <filesystem>
#include <new>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/whole_file.h"

namespace offing::meshes {

/// What `parse` makes of the bytes of a mesh file. Throws Error as read_whole_file() and `parse`, and
/// Error(out_of_memory) where memory ends.
template <typename Parse>
auto parse_mesh_file(const std::filesystem::path& path, Parse parse) {
  try {
    constexpr std::size_t most_bytes = std::size_t{1} << 36;
    const std::string bytes = read_whole_file(path, {.kind = "a mesh file", .most_bytes = most_bytes});
    return parse(bytes);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("{}: not enough memory for its mesh", one_line(path.string())),
                "cut the mesh into parts");
  }
}

}  // namespace offing::meshes
