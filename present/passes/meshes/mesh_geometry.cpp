#include "present/passes/meshes/mesh_geometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "host/highlights/search/unit_vector.h"

namespace offing::present {
namespace {

// As the shaders read it: mesh_place.glsl, mesh.vert, mesh_outline.vert.
struct Vertex {
  glm::vec3 position_m, normal;
  glm::vec2 curvatures_per_m;
  glm::vec3 outward;
};

/// The mean of the normals of all faces around each place: corners with edges of their own grow as one.
std::vector<glm::dvec3> outward_normals(const highlights::HighlightSurface& surface) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<glm::dvec3> sums(surface.links().place_count(), glm::dvec3(0.0));
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t corner : mesh.faces[face]) {
      sums[surface.links().place_of(corner)] += surface.face_normals()[face];
    }
  }
  for (glm::dvec3& sum : sums) sum = unit_or_zero(sum);
  return sums;
}

std::vector<Vertex> packed_vertices(const highlights::HighlightSurface& surface) {
  const TriangleMesh& mesh = surface.mesh();
  const VertexCurvatures& bends = surface.curvatures();
  const std::vector<glm::dvec3> outward = outward_normals(surface);
  std::vector<Vertex> vertices;
  vertices.reserve(mesh.positions_m.size());
  for (std::uint32_t i = 0; i < mesh.positions_m.size(); ++i) {
    vertices.push_back({.position_m = mesh.positions_m[i] - surface.middle_m(),
                        .normal = mesh.normals[i],
                        .curvatures_per_m = {bends.k_max_per_m[i], bends.k_min_per_m[i]},
                        .outward = outward[surface.links().place_of(i)]});
  }
  return vertices;
}

/// A side of a face, known by the places of its ends.
struct Side {
  std::uint32_t low_place, high_place, face, corner;
  bool is_at(const Side& other) const {
    return low_place == other.low_place && high_place == other.high_place;
  }
};

/// The sides that no other face has.
std::vector<Side> border_sides(const highlights::HighlightSurface& surface) {
  const std::vector<TriangleIndices>& faces = surface.mesh().faces;
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const auto [low, high] = std::minmax({surface.links().place_of(faces[face][corner]),
                                            surface.links().place_of(faces[face][(corner + 1) % 3])});
      if (low != high) sides.push_back({low, high, face, corner});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low_place, a.high_place, a.face) < std::tie(b.low_place, b.high_place, b.face);
  });
  std::vector<Side> borders;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool is_shared =
        (i > 0 && sides[i].is_at(sides[i - 1])) || (i + 1 < sides.size() && sides[i].is_at(sides[i + 1]));
    if (!is_shared) borders.push_back(sides[i]);
  }
  return borders;
}

/// Two triangles a border side: their inner ends stay, the outer ones go away from the face.
std::vector<Vertex> border_strips(const highlights::HighlightSurface& surface) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<Vertex> strips;
  for (const Side& side : border_sides(surface)) {
    const TriangleIndices& face = mesh.faces[side.face];
    const glm::dvec3 a = mesh.positions_m[face[side.corner]] - surface.middle_m();
    const glm::dvec3 b = mesh.positions_m[face[(side.corner + 1) % 3]] - surface.middle_m();
    const glm::dvec3 across = glm::cross(b - a, surface.face_normals()[side.face]);
    const double length = glm::length(across);
    if (!(length > 0.0)) continue;
    const auto vertex = [](const glm::dvec3& position_m, const glm::dvec3& outward) {
      return Vertex{.position_m = position_m, .normal = {}, .curvatures_per_m = {}, .outward = outward};
    };
    const glm::dvec3 away = across / length, stays(0.0);
    for (const Vertex& end : {vertex(a, stays), vertex(b, stays), vertex(b, away), vertex(a, stays),
                              vertex(b, away), vertex(a, away)}) {
      strips.push_back(end);
    }
  }
  return strips;
}

std::vector<glm::vec4> packed_faces(const highlights::HighlightSurface& surface) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<glm::vec4> texels;
  texels.reserve(2 * mesh.faces.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    glm::dvec3 middle_m = -surface.middle_m();
    for (const std::uint32_t corner : mesh.faces[face]) middle_m += mesh.positions_m[corner] / 3.0;
    texels.emplace_back(glm::vec3(surface.face_normals()[face]), 0.0f);
    texels.emplace_back(glm::vec3(middle_m), 0.0f);
  }
  return texels;
}

template <class T>
void fill(GLenum target, const GlBuffer& buffer, const std::vector<T>& values, GLenum use) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), use);
}

void bind_vertices(const GlVertexArray& array, const GlBuffer& vertices, GLuint corners) {
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, corners);
  struct Attribute {
    GLint floats;
    std::size_t offset;
  };
  const std::array<Attribute, 4> attributes{{{3, offsetof(Vertex, position_m)},
                                             {3, offsetof(Vertex, normal)},
                                             {2, offsetof(Vertex, curvatures_per_m)},
                                             {3, offsetof(Vertex, outward)}}};
  for (GLuint i = 0; i < attributes.size(); ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, attributes[i].floats, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(attributes[i].offset));
  }
}

}  // namespace

MeshGeometry::MeshGeometry(const highlights::HighlightSurface& surface)
    : all_(GlVertexArray::make()),
      some_(GlVertexArray::make()),
      strips_(GlVertexArray::make()),
      vertices_(GlBuffer::make()),
      corners_(GlBuffer::make()),
      some_corners_(GlBuffer::make()),
      strip_vertices_(GlBuffer::make()),
      faces_(GlBuffer::make()),
      face_texels_(GlTexture::make()),
      count_(static_cast<GLsizei>(3 * surface.mesh().faces.size())),
      strip_count_(0),
      low_m_(std::numeric_limits<double>::infinity()),
      high_m_(-low_m_) {
  for (const glm::dvec3& position_m : surface.mesh().positions_m) {
    low_m_ = glm::min(low_m_, position_m - surface.middle_m());
    high_m_ = glm::max(high_m_, position_m - surface.middle_m());
  }
  const std::vector<Vertex> strips = border_strips(surface);
  strip_count_ = static_cast<GLsizei>(strips.size());
  bind_vertices(strips_, strip_vertices_, 0);
  fill(GL_ARRAY_BUFFER, strip_vertices_, strips, GL_STATIC_DRAW);
  bind_vertices(all_, vertices_, corners_.name());
  fill(GL_ARRAY_BUFFER, vertices_, packed_vertices(surface), GL_STATIC_DRAW);
  fill(GL_ELEMENT_ARRAY_BUFFER, corners_, surface.mesh().faces, GL_STATIC_DRAW);
  bind_vertices(some_, vertices_, some_corners_.name());
  glBindVertexArray(0);
  fill(GL_TEXTURE_BUFFER, faces_, packed_faces(surface), GL_STATIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, face_texels_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, faces_.name());
}

void MeshGeometry::draw() const {
  glBindVertexArray(all_.name());
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void MeshGeometry::draw(GLsizei first_index, GLsizei count) const {
  glBindVertexArray(some_.name());
  glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(static_cast<std::size_t>(first_index) * sizeof(GLuint)));
}

void MeshGeometry::draw_borders() const {
  glBindVertexArray(strips_.name());
  glDrawArrays(GL_TRIANGLES, 0, strip_count_);
}

void MeshGeometry::set_drawn_faces(const std::vector<std::uint32_t>& corners) const {
  glBindVertexArray(some_.name());
  fill(GL_ELEMENT_ARRAY_BUFFER, some_corners_, corners, GL_STREAM_DRAW);
}

void MeshGeometry::bind_faces(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, face_texels_.name());
}

}  // namespace offing::present
