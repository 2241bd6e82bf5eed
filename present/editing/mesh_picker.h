#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/highlights/search/face_tree.h"
#include "host/world/world_mesh.h"

namespace offing::present {

/// A highlight of a world, from frame to frame.
struct HighlightName {
  std::size_t mesh = 0;  ///< in the world's order
  std::uint64_t id = 0;

  bool operator==(const HighlightName&) const = default;
};

/// The one that this is the name of, of several looks the most opaque; nullptr where it is gone.
const highlights::DrawnHighlight* find_highlight(const std::vector<world::WorldMesh>& meshes,
                                                 const HighlightName& name);

/// Where a ray meets a mesh first.
struct MeshHit {
  std::size_t mesh = 0;  ///< in the world's order
  double distance_m = 0.0;
  /// The one whose box is nearest to the place, by its own half widths; nothing where that is more than two
  /// of them away.
  std::optional<HighlightName> highlight = {};
};

/// Finds what a ray through a point of the picture meets, among meshes as they were shown last.
class MeshPicker {
 public:
  /// Nothing where no mesh is. `clip` are clip coordinates.
  std::optional<MeshHit> hit(const std::vector<world::WorldMesh>& meshes, const Camera& camera,
                             glm::dvec2 clip);

 private:
  struct Tree {
    std::uint64_t revision;  // of the view that it was made of
    highlights::FaceTree tree;
  };

  void prepare(const std::vector<world::WorldMesh>& meshes);

  std::vector<Tree> trees_;  // in the order of the world's meshes
};

}  // namespace offing::present
