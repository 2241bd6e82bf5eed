#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/io/meshes/mesh_file.h"
#include "tests/fuzz/expect.h"

namespace offing::fuzz {

/// What host/base/triangle_mesh.h promises, and that no face is lost: each is there, cut or counted.
inline void expect_contract(const MeshFile& file) {
  const TriangleMesh& mesh = file.mesh;
  const MeshReport& report = file.report;
  expect(!mesh.faces.empty() && report.file_vertices == mesh.positions_m.size());
  for (const glm::dvec3& position : mesh.positions_m) {
    for (int axis = 0; axis < 3; ++axis) expect(std::isfinite(position[axis]));
  }
  expect(mesh.normals.empty() || mesh.normals.size() == mesh.positions_m.size());
  for (const glm::dvec3& normal : mesh.normals) expect(std::abs(glm::length(normal) - 1.0) < 1e-9);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face) expect(corner < mesh.positions_m.size());
  }
  std::size_t without_corners = 0;
  for (const LeftOut& item : report.left_out) {
    expect(item.count > 0);
    if (item.what == "faces of fewer than three corners") without_corners = item.count;
  }
  const std::size_t kept = report.file_faces - without_corners;
  expect(mesh.faces.size() >= kept + report.polygons && report.polygons <= kept);
}

/// Forms of a mesh that deforms have its vertices, in and beyond its time.
inline void expect_forms(const MeshFile& file) {
  if (!file.deformation) return;
  expect(file.deformation.end_s >= 0.0 && std::isfinite(file.deformation.end_s));
  for (const double part : {-1.0, 0.0, 0.4, 1.0}) {
    const MeshForm form = file.deformation.form_at(part * file.deformation.end_s);
    expect(form.positions_m.size() == file.mesh.positions_m.size());
    expect(form.normals.size() == file.mesh.normals.size());
    for (const glm::dvec3& position : form.positions_m) {
      for (int axis = 0; axis < 3; ++axis) expect(std::isfinite(position[axis]));
    }
  }
}

/// Runs `parse`: it must return a mesh that keeps the contract, or throw Error of one line with a hint.
template <class Parse>
int check_mesh_reader(Parse parse) {
  try {
    const MeshFile file = parse();
    expect_contract(file);
    expect_forms(file);
  } catch (const Error& error) {
    expect_told(error);
  }
  return 0;
}

}  // namespace offing::fuzz
