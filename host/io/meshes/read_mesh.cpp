#include "host/io/meshes/read_mesh.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/error_report.h"
#include "host/base/log.h"
#include "host/io/meshes/obj_mesh.h"
#include "host/io/meshes/off_mesh.h"
#include "host/io/meshes/ply_mesh.h"
#include "host/io/meshes/text_lines.h"
#include "host/io/whole_file.h"

namespace offing {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string_view first_word(std::string_view text) {
  meshes::TextLines lines(text.substr(0, 4096), "");
  return lines.next_line() ? lines.word() : std::string_view();
}

MeshFile parse(std::string_view bytes, const std::filesystem::path& path) {
  const std::string name = path.string(), extension = lower_extension(path);
  const std::string_view word = first_word(bytes);
  if (word == "ply" || extension == ".ply") return meshes::parse_ply(bytes, name).file;
  if (extension == ".obj") return meshes::parse_obj(bytes, name);
  if (meshes::is_off_keyword(word) || extension == ".off") return meshes::parse_off(bytes, name);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a mesh, got {}", one_line(name),
                          bytes.empty() ? "an empty file" : "a file of no format that is known"),
              "formats read: .obj, .ply, .off, .stl, .gltf, .glb");
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path) {
  try {
    constexpr std::size_t most_bytes = std::size_t{1} << 36;
    const std::string bytes = read_whole_file(path, {.kind = "a mesh file", .most_bytes = most_bytes});
    return parse(bytes, path);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("{}: not enough memory for its mesh", one_line(path.string())),
                "cut the mesh into parts");
  }
}

TriangleMesh read_mesh(const std::filesystem::path& path) {
  MeshFile file = read_mesh_file(path);
  for (const LeftOut& item : file.report.left_out) {
    spdlog::warn("{}: left out: {} {}", one_line(path.string()), item.count, item.what);
  }
  return std::move(file.mesh);
}

}  // namespace offing
