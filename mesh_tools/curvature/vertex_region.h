#pragma once

#include <algorithm>
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

  /// Reaches vertices that hang together with one within a ball about it, ring by ring. What follows from a
  /// comparison is counted, not branched on: half of the branches would be predicted wrongly.
  void grow_vertices(std::uint32_t vertex, double radius) {
    ++number_;
    queue_.assign(1, vertex);
    vertex_marks_[vertex] = number_;
    const glm::dvec3 middle = mesh_.positions[vertex];
    for (std::size_t begin = 0; begin < queue_.size();) {
      std::size_t room = 0, found = 0;
      for (std::size_t i = begin; i < queue_.size(); ++i)
        room += mesh_.neighbours.neighbours_of(queue_[i]).size();
      ring_.resize(std::max(ring_.size(), room));
      for (std::size_t i = begin; i < queue_.size(); ++i) {
        for (const std::uint32_t other : mesh_.neighbours.neighbours_of(queue_[i])) {
          ring_[found] = other;
          found += vertex_marks_[other] != number_ ? 1 : 0;
          vertex_marks_[other] = number_;
        }
      }
      begin = queue_.size();
      std::size_t end = begin;
      queue_.resize(begin + found);
      for (std::size_t i = 0; i < found; ++i) {
        const glm::dvec3 off = mesh_.positions[ring_[i]] - middle;
        queue_[end] = ring_[i];
        end += glm::dot(off, off) < radius * radius ? 1 : 0;
      }
      queue_.resize(end);
    }
  }

  /// The vertices that the last region reached, the middle first.
  const std::vector<std::uint32_t>& vertices() const { return queue_; }

 private:
  const UnitMesh& mesh_;
  std::vector<std::uint32_t> vertex_marks_, face_marks_, queue_, ring_;
  std::uint32_t number_ = 0;
};

}  // namespace offing::mesh_tools
