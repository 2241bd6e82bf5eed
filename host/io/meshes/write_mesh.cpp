#include "host/io/meshes/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/meshes/obj_writer.h"
#include "host/io/meshes/ply_writer.h"

namespace offing {
namespace {

Error cannot_write(const std::filesystem::path& path, std::string_view expected, std::string_view got) {
  return {ErrorKind::bad_input,
          fmt::format("{}: cannot be written: expected {}, got {}", one_line(path.string()), expected, got),
          "check the program that made the mesh"};
}

bool is_finite(const glm::dvec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void check(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const std::size_t count = mesh.positions_m.size();
  if (!mesh.normals.empty() && mesh.normals.size() != count) {
    throw cannot_write(path, fmt::format("{} normals", count), fmt::format("{}", mesh.normals.size()));
  }
  if (!std::all_of(mesh.positions_m.begin(), mesh.positions_m.end(), is_finite) ||
      !std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite)) {
    throw cannot_write(path, "finite positions and normals", "others");
  }
  for (const TriangleIndices& face : mesh.faces) {
    const std::uint32_t highest = *std::max_element(face.begin(), face.end());
    if (highest >= count)
      throw cannot_write(path, fmt::format("{} vertices", count), fmt::format("{}", highest));
  }
}

bool is_word(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), fits);
}

void check(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexAttributes& attributes) {
  const std::size_t count = mesh.positions_m.size();
  for (const VertexProperty& property : attributes.properties) {
    if (!is_word(property.name)) throw cannot_write(path, "names of letters, digits and _", property.name);
    if (property.values.size() != count) {
      throw cannot_write(path, fmt::format("{} values of {}", count, property.name),
                         fmt::format("{}", property.values.size()));
    }
    for (const double value : property.values) {
      if (std::isfinite(static_cast<float>(value))) continue;
      throw cannot_write(path, fmt::format("finite values of {}", property.name), fmt::format("{:g}", value));
    }
  }
  if (!attributes.colours.empty() && attributes.colours.size() != count) {
    throw cannot_write(path, fmt::format("{} colours", count), fmt::format("{}", attributes.colours.size()));
  }
  for (const std::string& comment : attributes.comments) {
    if (comment.find_first_of("\r\n") != std::string::npos)
      throw cannot_write(path, "comments of a line", "more");
  }
}

bool are_floats(const std::vector<glm::dvec3>& positions) {
  const auto is_float = [](double value) { return static_cast<double>(static_cast<float>(value)) == value; };
  return std::all_of(positions.begin(), positions.end(),
                     [&](const glm::dvec3& p) { return is_float(p.x) && is_float(p.y) && is_float(p.z); });
}

void put_floats(meshes::PlyWriter& file, const glm::dvec3& vector) {
  for (int axis = 0; axis < 3; ++axis) file.put(static_cast<float>(vector[axis]));
}

void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh, Existing existing) {
  meshes::ObjWriter file(
      path, fmt::format("{} vertices, {} faces", mesh.positions_m.size(), mesh.faces.size()), existing);
  for (const glm::dvec3& position : mesh.positions_m) file.put_vector("v", position);
  for (const glm::dvec3& normal : mesh.normals) file.put_vector("vn", normal);
  using Normals = meshes::ObjWriter::Normals;
  const Normals normals = mesh.normals.empty() ? Normals::none : Normals::same_index;
  for (const TriangleIndices& face : mesh.faces) file.put_triangle(face, normals);
  file.commit();
}

void write_off(const std::filesystem::path& path, const TriangleMesh& mesh, Existing existing) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions_m.size(), mesh.faces.size());
  const auto out = std::back_inserter(text);
  for (const glm::dvec3& p : mesh.positions_m) fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z);
  for (const TriangleIndices& face : mesh.faces)
    fmt::format_to(out, "3 {} {} {}\n", face[0], face[1], face[2]);
  write_file_atomically(path, text, existing);
}

/// 80 bytes of header, the count of facets, and for each its normal, its corners and two bytes that mean
/// nothing.
void write_stl(const std::filesystem::path& path, const TriangleMesh& mesh, Existing existing) {
  AtomicFile file(path, existing);
  std::string header = "binary STL, metres";
  header.resize(80, ' ');
  file.write(header);
  const auto count = static_cast<std::uint32_t>(mesh.faces.size());
  if (count != mesh.faces.size()) throw cannot_write(path, "fewer than 2^32 faces in an STL", "more");
  file.write(&count, sizeof(count));
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3 &a = mesh.positions_m[face[0]], &b = mesh.positions_m[face[1]],
                     &c = mesh.positions_m[face[2]];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    const glm::dvec3 normal = length > 0.0 && std::isfinite(length) ? cross / length : glm::dvec3(0.0);
    std::array<float, 12> numbers{};
    std::size_t next = 0;
    for (const glm::dvec3& vector : {normal, a, b, c}) {
      for (int axis = 0; axis < 3; ++axis) numbers[next++] = static_cast<float>(vector[axis]);
    }
    if (!std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); })) {
      throw cannot_write(path, "positions that floats can hold", "larger ones");
    }
    constexpr std::uint16_t no_attribute = 0;
    file.write(numbers.data(), sizeof(numbers));
    file.write(&no_attribute, sizeof(no_attribute));
  }
  file.commit();
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh,
               const VertexAttributes& attributes, Existing existing) {
  check(path, mesh);
  check(path, mesh, attributes);
  const bool has_floats = are_floats(mesh.positions_m);
  std::vector<meshes::PlyColumn> columns;
  for (const char* name : {"x", "y", "z"}) columns.push_back({has_floats ? "float" : "double", name});
  if (!mesh.normals.empty()) {
    for (const char* name : {"nx", "ny", "nz"}) columns.push_back({"float", name});
  }
  for (const VertexProperty& property : attributes.properties) columns.push_back({"float", property.name});
  if (!attributes.colours.empty()) {
    for (const char* name : {"red", "green", "blue"}) columns.push_back({"uchar", name});
  }
  meshes::PlyWriter file(path, attributes.comments, columns, {mesh.positions_m.size(), mesh.faces.size()},
                         existing);
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    if (has_floats) {
      put_floats(file, mesh.positions_m[i]);
    } else {
      for (int axis = 0; axis < 3; ++axis) file.put(mesh.positions_m[i][axis]);
    }
    if (!mesh.normals.empty()) put_floats(file, mesh.normals[i]);
    for (const VertexProperty& property : attributes.properties)
      file.put(static_cast<float>(property.values[i]));
    if (!attributes.colours.empty()) {
      for (const std::uint8_t part : attributes.colours[i]) file.put(part);
    }
  }
  for (const TriangleIndices& face : mesh.faces) file.put_triangle(face);
  file.commit();
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, Existing existing) {
  require_mesh_extension(path);
  const std::string extension = path.extension().string();
  if (extension == ".ply") {
    write_ply(path, mesh, {}, existing);
    return;
  }
  check(path, mesh);
  if (extension == ".obj") {
    write_obj(path, mesh, existing);
  } else if (extension == ".off") {
    write_off(path, mesh, existing);
  } else {
    write_stl(path, mesh, existing);
  }
}

void require_mesh_extension(const std::filesystem::path& path) {
  require_extension(path, {".ply", ".obj", ".off", ".stl"});
}

}  // namespace offing
