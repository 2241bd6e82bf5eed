#include "host/io/meshes/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/io/meshes/gltf_document.h"
#include "host/io/meshes/polygon_soup.h"

namespace offing::meshes {
namespace {

using nlohmann::json;

/// A document may show a mesh again and again: so many times its own bytes is enough.
constexpr std::size_t most_corners_a_byte = 1000;

// Modes of primitives, glTF 2.0, 5.24.
constexpr std::size_t triangles = 4, triangle_strip = 5, triangle_fan = 6;

class GltfParser {
 public:
  GltfParser(std::string_view bytes, const std::filesystem::path& path, Trust trust)
      : document_(bytes, path, trust),
        soup_(path.string()),
        has_mesh_been_shown_(document_.count("meshes"), 0) {
    soup_.report.format = document_.is_binary() ? "glTF, binary" : "glTF";
  }

  MeshFile parse() {
    check_extensions();
    if (document_.count("nodes") == 0) {
      for (std::size_t i = 0; i < document_.count("meshes"); ++i) add_mesh(i, glm::dmat4(1.0));
    } else {
      walk(roots());
    }
    const auto hidden = std::count(has_mesh_been_shown_.begin(), has_mesh_been_shown_.end(), 0);
    soup_.leave_out("meshes that the scene does not show", static_cast<std::size_t>(hidden));
    soup_.leave_out("bytes after the end", document_.bytes_over());
    if (!have_all_normals_) {
      soup_.leave_out("normals, since some vertices have none or several", soup_.normals.size());
      soup_.normals.clear();
    }
    return std::move(soup_).finish();
  }

 private:
  void check_extensions() const {
    constexpr std::array<std::string_view, 5> harmless = {"KHR_mesh_quantization", "KHR_materials_",
                                                          "KHR_texture_", "EXT_texture_", "KHR_lights_"};
    const auto required = document_.root().find("extensionsRequired");
    if (required == document_.root().end()) return;
    for (const json& extension : *required) {
      const std::string name = shown(extension);
      const bool is_harmless = std::any_of(harmless.begin(), harmless.end(),
                                           [&](std::string_view prefix) { return name.starts_with(prefix); });
      if (!is_harmless) document_.fail("a glTF without compression and other extensions", name);
    }
  }

  std::vector<std::size_t> children(const json& object, const char* key) const {
    std::vector<std::size_t> indices;
    const auto list = object.find(key);
    if (list == object.end()) return indices;
    if (!list->is_array()) document_.fail(fmt::format("a list {}", key), list->type_name());
    for (const json& index : *list) {
      if (!index.is_number_unsigned()) document_.fail(fmt::format("numbers in {}", key), shown(index));
      indices.push_back(index.get<std::size_t>());
    }
    return indices;
  }

  /// Nodes of the scene, or without scenes those that are no other's child.
  std::vector<std::size_t> roots() const {
    if (document_.count("scenes") > 0) {
      return children(document_.object("scenes", document_.whole(document_.root(), "scene", 0)), "nodes");
    }
    const std::size_t count = document_.count("nodes");
    std::vector<std::uint8_t> is_child(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      for (const std::size_t child : children(document_.object("nodes", i), "children")) {
        if (child < count) is_child[child] = 1;
      }
    }
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < count; ++i) {
      if (is_child[i] == 0) nodes.push_back(i);
    }
    return nodes;
  }

  glm::dmat4 transform(const json& node) const {
    if (const std::vector<double> matrix = document_.numbers(node, "matrix", 16); !matrix.empty()) {
      return glm::make_mat4(matrix.data());  // columns first, as in glTF
    }
    glm::dmat4 transform(1.0);
    if (const auto t = document_.numbers(node, "translation", 3); !t.empty()) {
      transform = glm::translate(transform, glm::dvec3(t[0], t[1], t[2]));
    }
    if (const auto q = document_.numbers(node, "rotation", 4); !q.empty()) {
      transform *= glm::mat4_cast(glm::dquat(q[3], q[0], q[1], q[2]));
    }
    if (const auto s = document_.numbers(node, "scale", 3); !s.empty()) {
      transform = glm::scale(transform, glm::dvec3(s[0], s[1], s[2]));
    }
    return transform;
  }

  /// Depth first, children in their order. A node has one parent at most, so none comes twice.
  void walk(const std::vector<std::size_t>& roots) {
    struct Visit {
      std::size_t node;
      glm::dmat4 parent;
    };
    std::vector<std::uint8_t> is_visited(document_.count("nodes"), 0);
    std::vector<Visit> stack;
    const auto push = [&](std::vector<std::size_t> nodes, const glm::dmat4& parent) {
      std::reverse(nodes.begin(), nodes.end());  // the first is taken first
      for (const std::size_t node : nodes) stack.push_back({node, parent});
    };
    push(roots, glm::dmat4(1.0));
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      const json& node = document_.object("nodes", visit.node);
      if (std::exchange(is_visited[visit.node], 1) != 0) {
        document_.fail("a tree of nodes", fmt::format("two ways to node {}", visit.node));
      }
      const glm::dmat4 to_world = visit.parent * transform(node);
      if (node.contains("mesh")) add_mesh(document_.whole(node, "mesh", std::nullopt), to_world);
      if (node.contains("skin")) soup_.leave_out("skins");
      push(children(node, "children"), to_world);
    }
  }

  void add_mesh(std::size_t index, const glm::dmat4& to_world) {
    const json& mesh = document_.object("meshes", index);
    has_mesh_been_shown_[index] = 1;
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      document_.fail("primitives of each mesh", "none");
    if (mesh.contains("weights")) soup_.leave_out("morphs");
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> first_vertices;  // by accessors
    for (const json& primitive : *primitives) add_primitive(primitive, to_world, first_vertices);
  }

  void add_primitive(const json& primitive, const glm::dmat4& to_world,
                     std::map<std::pair<std::size_t, std::size_t>, std::size_t>& first_vertices) {
    if (!primitive.is_object()) document_.fail("objects as primitives", primitive.type_name());
    const std::size_t mode = document_.whole(primitive, "mode", triangles);
    if (mode > triangle_fan) document_.fail("a mode of 0 to 6", fmt::format("{}", mode));
    if (mode < triangles) {
      soup_.leave_out("sets of points or lines");
      return;
    }
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) {
      document_.fail("positions of each primitive", "none");
    }
    constexpr std::size_t none = SIZE_MAX;
    const std::size_t position_accessor = document_.whole(*attributes, "POSITION", std::nullopt);
    const std::size_t normal_accessor = document_.whole(*attributes, "NORMAL", none);
    const auto [entry, is_new] =
        first_vertices.try_emplace({position_accessor, normal_accessor}, soup_.positions_m.size());
    if (is_new) {
      const std::vector<glm::dvec3> positions = document_.vectors(position_accessor);
      if (attributes->contains("COLOR_0")) soup_.leave_out("colours of vertices", positions.size());
      if (attributes->contains("TEXCOORD_0"))
        soup_.leave_out("texture coordinates of vertices", positions.size());
      add_vertices(positions, to_world);
      add_normals(normal_accessor == none ? std::vector<glm::dvec3>() : document_.vectors(normal_accessor),
                  positions.size(), to_world);
    }
    const std::size_t first = entry->second, count = vertex_count(position_accessor);
    std::vector<std::uint32_t> corners;
    if (primitive.contains("indices")) {
      corners = document_.indices(document_.whole(primitive, "indices", std::nullopt));
    } else {
      corners.resize(count);
      for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
    }
    grow(corners.size());
    for (std::uint32_t& corner : corners) {
      if (corner >= count) document_.fail(fmt::format("indices below {}", count), fmt::format("{}", corner));
      corner += static_cast<std::uint32_t>(first);
    }
    const bool is_mirrored = glm::determinant(glm::dmat3(to_world)) < 0.0;
    add_faces(corners, mode, is_mirrored);
  }

  std::size_t vertex_count(std::size_t accessor) const {
    return document_.whole(document_.object("accessors", accessor), "count", std::nullopt);
  }

  /// Throws Error where instances of meshes grow out of proportion.
  void grow(std::size_t count) {
    corners_ += count;
    if (corners_ / most_corners_a_byte > document_.bytes() || soup_.positions_m.size() > most_vertices) {
      document_.fail("a scene of less than 1000 corners per byte", "more");
    }
  }

  void add_vertices(const std::vector<glm::dvec3>& positions, const glm::dmat4& to_world) {
    grow(positions.size());
    for (const glm::dvec3& position : positions) {
      soup_.positions_m.emplace_back(to_world * glm::dvec4(position, 1.0));
    }
  }

  void add_normals(const std::vector<glm::dvec3>& normals, std::size_t count, const glm::dmat4& to_world) {
    if (normals.size() != count) have_all_normals_ = false;
    if (!have_all_normals_) return;
    // The cofactors: the inverse's transpose without its division, that is for flat scalings, too.
    const glm::dmat3 m(to_world);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    for (const glm::dvec3& normal : normals) soup_.normals.emplace_back(sign * (cofactors * normal));
  }

  void add_faces(std::span<const std::uint32_t> corners, std::size_t mode, bool is_mirrored) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      soup_.add_face(is_mirrored ? std::array{a, c, b} : std::array{a, b, c});
    };
    if (mode == triangles) {
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add(corners[i], corners[i + 1], corners[i + 2]);
      if (corners.size() % 3 != 0) soup_.add_face(corners.last(corners.size() % 3));
      return;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      // glTF 2.0, 3.7.2.1: every second triangle of a strip is turned over.
      const std::size_t turn = i % 2;
      if (mode == triangle_strip) {
        add(corners[i], corners[i + 1 + turn], corners[i + 2 - turn]);
      } else {
        add(corners[i + 1], corners[i + 2], corners[0]);
      }
    }
  }

  GltfDocument document_;
  PolygonSoup soup_;
  std::vector<std::uint8_t> has_mesh_been_shown_;
  bool have_all_normals_ = true;
  std::size_t corners_ = 0;
};

}  // namespace

MeshFile parse_gltf(std::string_view bytes, const std::filesystem::path& path, Trust trust) {
  return GltfParser(bytes, path, trust).parse();
}

}  // namespace offing::meshes
