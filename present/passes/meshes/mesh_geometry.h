#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/highlights/search/highlight_surface.h"
#include "present/gl/gl_objects.h"

namespace offing::present {

/// OpenGL's copy of a mesh: vertices relative to its middle, in its own axes.
class MeshGeometry {
 public:
  explicit MeshGeometry(const highlights::HighlightSurface& surface);

  /// Of the box around the vertices.
  const glm::dvec3& low_m() const { return low_m_; }
  const glm::dvec3& high_m() const { return high_m_; }

  /// Draws all faces in their order.
  void draw() const;
  /// Draws these faces one after another, as if they were a mesh of their own.
  void draw(GLsizei first_index, GLsizei count) const;
  /// Draws strips along the borders of an open mesh, which the outline's shader widens.
  void draw_borders() const;
  /// Gives draw(first, count) the faces' corners, three a face.
  void set_drawn_faces(const std::vector<std::uint32_t>& corners) const;
  /// Binds unit normal and middle of each face, two texels of four floats, to a unit of buffer textures.
  void bind_faces(int unit) const;

 private:
  GlVertexArray all_, some_, strips_;
  GlBuffer vertices_, corners_, some_corners_, strip_vertices_, faces_;
  GlTexture face_texels_;
  GLsizei count_, strip_count_;
  glm::dvec3 low_m_, high_m_;
};

}  // namespace offing::present
