#include "present/passes/meshes/mesh_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "present/passes/meshes/highlight_pass.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr double stroke_share = 0.35;  // of the mean edge, either way
constexpr double least_confidence = 0.02;

ShaderProgram line_program() {
  return ShaderProgram(plain_stages({"meshes/mesh_line.vert"}));
}

/// Ends of a box's edges, and of the two that make a tip on its upper front edge.
std::vector<glm::vec3> box_lines(const highlights::Projector& projector, const glm::dvec3& middle_m) {
  const double depth_m = 0.5 * std::min(projector.width_m, projector.height_m);
  const auto corner = [&](double right, double up, double out) {
    return glm::vec3(projector.centre_m - middle_m + 0.5 * right * projector.width_m * projector.right +
                     0.5 * up * projector.height_m * projector.up + 0.5 * out * depth_m * projector.normal);
  };
  std::vector<glm::vec3> ends;
  const auto line = [&](const glm::vec3& a, const glm::vec3& b) {
    ends.push_back(a);
    ends.push_back(b);
  };
  for (const double one : {-1.0, 1.0}) {
    for (const double other : {-1.0, 1.0}) {
      line(corner(-1.0, one, other), corner(1.0, one, other));
      line(corner(one, -1.0, other), corner(one, 1.0, other));
      line(corner(one, other, -1.0), corner(one, other, 1.0));
    }
    line(corner(0.3 * one, 1.0, 1.0), corner(0.0, 1.3, 1.0));
  }
  return ends;
}

}  // namespace

MeshLines::MeshLines()
    : program_(line_program()),
      block_("Plain", pass_binding),
      array_(GlVertexArray::make()),
      ends_(GlBuffer::make()) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, ends_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  glBindVertexArray(0);
}

void MeshLines::draw(const std::vector<glm::vec3>& ends_m, const glm::vec3& colour,
                     const MeshViewMatrices& matrices, const FrameRequest& request) {
  program_.use();
  glsl::PlainUniforms plain{};
  plain.light = {colour / static_cast<float>(request.exposure), 1.0f};
  block_.fill(matrices.uniforms(), plain);
  block_.bind(program_);
  glDepthFunc(GL_GREATER);
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, ends_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ends_m.size() * sizeof(glm::vec3)), ends_m.data(),
               GL_STREAM_DRAW);
  glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(ends_m.size()));
}

void MeshLines::draw_directions(const world::WorldMesh& mesh, const MeshViewMatrices& matrices,
                                const FrameRequest& request) {
  const highlights::HighlightSurface& surface = mesh.surface();
  const VertexCurvatures& bends = surface.curvatures();
  const auto strokes = [&](const std::vector<glm::dvec3>& directions, const glm::vec3& colour) {
    std::vector<glm::vec3> ends_m;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (bends.confidence[i] < least_confidence) continue;
      const glm::dvec3 place_m = surface.mesh().positions_m[i] - surface.middle_m();
      const glm::dvec3 way_m = stroke_share * surface.mean_edge_m() * directions[i];
      ends_m.emplace_back(place_m - way_m);
      ends_m.emplace_back(place_m + way_m);
    }
    draw(ends_m, colour, matrices, request);
  };
  strokes(bends.e_max, {0.9f, 0.05f, 0.03f});
  strokes(bends.e_min, {0.03f, 0.1f, 0.9f});
}

void MeshLines::draw_projectors(const world::WorldMesh& mesh, const MeshViewMatrices& matrices,
                                const FrameRequest& request) {
  for (const highlights::DrawnHighlight& highlight : mesh.highlights()) {
    draw(box_lines(highlight.projector, mesh.surface().middle_m()), id_colour(highlight.id), matrices,
         request);
  }
}

}  // namespace offing::present
