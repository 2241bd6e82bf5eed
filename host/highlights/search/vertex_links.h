#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::highlights {

/// Which vertices are one place, and which faces meet there. Nothing is assumed of the neighbourhood: an edge
/// may have any number of faces.
class VertexLinks {
 public:
  /// Vertices no farther apart than `distance_m` are one place (copies along a texture's seams, components
  /// that touch), in chains too; 0 joins equal positions only.
  VertexLinks(const TriangleMesh& mesh, double distance_m);

  std::size_t place_count() const { return first_face_.size() - 1; }
  std::uint32_t place_of(std::uint32_t vertex) const { return places_[vertex]; }
  /// Faces with a corner at a place, ascending; one with two corners there is named twice.
  std::span<const std::uint32_t> faces_at(std::uint32_t place) const {
    return std::span(faces_).subspan(first_face_[place], first_face_[place + 1] - first_face_[place]);
  }

 private:
  std::vector<std::uint32_t> places_;      // [vertices]
  std::vector<std::uint32_t> first_face_;  // [places + 1]
  std::vector<std::uint32_t> faces_;       // [3 faces]
};

}  // namespace offing::highlights
