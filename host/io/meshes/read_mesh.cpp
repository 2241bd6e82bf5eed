#include "host/io/meshes/read_mesh.h"

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/file_extension.h"
#include "host/io/meshes/gltf_document.h"
#include "host/io/meshes/gltf_mesh.h"
#include "host/io/meshes/mesh_bytes.h"
#include "host/io/meshes/obj_mesh.h"
#include "host/io/meshes/off_mesh.h"
#include "host/io/meshes/ply_mesh.h"
#include "host/io/meshes/stl_mesh.h"
#include "host/io/meshes/text_lines.h"

namespace offing {
namespace {

std::string_view first_word(std::string_view text) {
  meshes::TextLines lines(text.substr(0, 4096), "");
  return lines.next_line() ? lines.word() : std::string_view();
}

MeshFile parse(std::string_view bytes, const std::filesystem::path& path, Trust trust,
               const std::string& animation) {
  const std::string name = path.string(), extension = lower_extension(path);
  const std::string_view word = first_word(bytes);
  if (word == "ply" || extension == ".ply") return meshes::parse_ply(bytes, name).file;
  if (extension == ".obj") return meshes::parse_obj(bytes, name);
  if (meshes::is_off_keyword(word) || extension == ".off") return meshes::parse_off(bytes, name);
  if (extension == ".stl") return meshes::parse_stl(bytes, name);
  if (meshes::is_gltf(bytes, path)) return meshes::parse_gltf(bytes, path, trust, animation);
  if (word == "solid") return meshes::parse_stl(bytes, name);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a mesh, got {}", one_line(name),
                          bytes.empty() ? "an empty file" : "a file of unknown format"),
              "formats read: .obj, .ply, .off, .stl, .gltf, .glb");
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path, Trust trust, const std::string& animation) {
  return meshes::parse_mesh_file(
      path, [&](std::string_view bytes) { return parse(bytes, path, trust, animation); });
}

void warn_of_left_out(const std::filesystem::path& path, const MeshReport& report) {
  for (const LeftOut& item : report.left_out)
    spdlog::warn("{}: left out: {} {}", one_line(path.string()), item.count, item.what);
}

TriangleMesh read_mesh(const std::filesystem::path& path, Trust trust) {
  MeshFile file = read_mesh_file(path, trust);
  warn_of_left_out(path, file.report);
  return std::move(file.mesh);
}

}  // namespace offing
