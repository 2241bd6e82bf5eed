#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::highlights {

/// Where a ray meets a face.
struct FaceHit {
  std::uint32_t face = 0;
  double distance = 0.0;              ///< in lengths of the ray's direction
  glm::dvec3 weights{1.0, 0.0, 0.0};  ///< of the face's corners
};

/// Boxes around the faces of a mesh, for rays. Both sides of a face count; faces without an area are never
/// met.
class FaceTree {
 public:
  /// Keeps a copy of what it needs.
  explicit FaceTree(const TriangleMesh& mesh);

  /// The first face along origin + s direction, 0 < s < longest; in the mesh's axes.
  std::optional<FaceHit> first_hit(const glm::dvec3& origin_m, const glm::dvec3& direction,
                                   double longest) const;
  /// Whether there is any: quicker than to find the first.
  bool is_blocked(const glm::dvec3& origin_m, const glm::dvec3& direction, double longest) const;

 private:
  struct Corners {
    std::uint32_t face;
    glm::dvec3 first_m, side_1_m, side_2_m;
  };
  struct Node {
    glm::dvec3 low_m{0.0}, high_m{0.0};
    std::uint32_t begin = 0,
                  count = 0;  ///< of corners_; count 0: an inner node, whose halves are at begin, begin + 1
  };

  void split(std::size_t node);
  template <class Visit>
  void visit(const glm::dvec3& origin_m, const glm::dvec3& direction, double& longest,
             const Visit& is_done) const;

  std::vector<Corners> corners_;
  std::vector<Node> nodes_;
};

}  // namespace offing::highlights
