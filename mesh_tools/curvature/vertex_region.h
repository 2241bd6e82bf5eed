#pragma once

#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {

/// Grows regions about vertices, one after the other, by a thread of its own. What is found is marked with
/// the number of the region, so that nothing has to be wiped in between.
class Region {
 public:
  explicit Region(const UnitMesh& mesh)
      : mesh_(mesh), vertex_marks_(mesh.vertex_count(), 0), face_marks_(mesh.neighbours.faces.size(), 0) {}

  /// Visits faces that hang together with the vertex, each once: those around it, and those around every
  /// corner of a visited face for which reaches(corner, what visit said of the face) holds.
  template <typename Visit, typename Reaches>
  void grow(std::uint32_t vertex, const Visit& visit, const Reaches& reaches) {
    ++number_;
    queue_.assign(1, vertex);
    vertex_marks_[vertex] = number_;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      for (const std::uint32_t face : mesh_.neighbours.vertex_faces.row(queue_[i])) {
        if (face_marks_[face] == number_) continue;
        face_marks_[face] = number_;
        const bool is_in = visit(face);
        for (const std::uint32_t corner : mesh_.neighbours.faces[face]) {
          if (vertex_marks_[corner] == number_ || !reaches(corner, is_in)) continue;
          vertex_marks_[corner] = number_;
          queue_.push_back(corner);
        }
      }
    }
  }

  /// Reaches vertices that hang together with one within a ball about it.
  void grow_vertices(std::uint32_t vertex, double radius) {
    ++number_;
    queue_.assign(1, vertex);
    vertex_marks_[vertex] = number_;
    const glm::dvec3 middle = mesh_.positions[vertex];
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      for (const std::uint32_t other : mesh_.neighbours.neighbours_of(queue_[i])) {
        if (vertex_marks_[other] == number_) continue;
        vertex_marks_[other] = number_;
        const glm::dvec3 off = mesh_.positions[other] - middle;
        if (glm::dot(off, off) < radius * radius) queue_.push_back(other);
      }
    }
  }

  /// The vertices that the last region reached, the middle first.
  const std::vector<std::uint32_t>& vertices() const { return queue_; }

 private:
  const UnitMesh& mesh_;
  std::vector<std::uint32_t> vertex_marks_, face_marks_, queue_;
  std::uint32_t number_ = 0;
};

}  // namespace offing::mesh_tools
